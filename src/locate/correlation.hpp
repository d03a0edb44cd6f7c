// SPDX-License-Identifier: GPL-3.0-or-later
// What all shifts of one picture over another score, at once.
#pragma once

#include <complex>
#include <memory>
#include <vector>

struct fftwf_plan_s;

#include "roomatlas/grid/raster.hpp"

namespace roomatlas {

/// A building's picture in which others are looked for: two values a cell, wall and floor. Scores
/// of all shifts come from the convolution theorem (discrete Fourier transforms by FFTW, Frigo and
/// Johnson 2005), so that a search costs the same however much the query saw.
class CorrelationPlane {
 public:
  /// Values that a query's cell takes from the building's cell below it.
  struct Layers {
    Raster<float> on_wall;   ///< for each wall cell of the query
    Raster<float> on_floor;  ///< for each floor cell of the query; the same box
  };
  /// A query's cells, with a weight each.
  struct Query {
    Raster<float> wall;
    Raster<float> floor;  ///< the same box
  };

  /// @param layers of the building
  /// @param max_query_cells side of the largest query
  CorrelationPlane(const Layers& layers, int max_query_cells);

  /// For each shift of the query's cells, in the cells of the building, the sum of what they take.
  /// Shifts are those that keep some of the query's box on the building's.
  [[nodiscard]] Raster<float> scores(const Query& query) const;

 private:
  using Spectrum = std::vector<std::complex<float>>;
  struct Destroy {
    void operator()(fftwf_plan_s* plan) const;
  };
  using Plan = std::unique_ptr<fftwf_plan_s, Destroy>;
  [[nodiscard]] Plan plan(int sign) const;
  [[nodiscard]] Spectrum spectrum_of(const Raster<float>& real, const Raster<float>& imaginary,
                                     const Cell& origin) const;
  [[nodiscard]] std::size_t mirrored(std::size_t at) const;

  CellBox building_;
  int width_ = 0;  ///< of the plane, in cells: the building and a query's margin, of small factors
  int height_ = 0;
  Plan forward_;
  Plan backward_;
  Spectrum on_wall_;
  Spectrum on_floor_;
};

}  // namespace roomatlas
