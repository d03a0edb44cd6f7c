// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/draft/wall_faces.hpp"

namespace roomatlas {

/// How faces of one direction are found.
struct RunOptions {
  double bin_along_m = 0.1;
  double half_band_m = 0.04;  ///< surfaces this near a line are on it; sonars need more
  double min_hits = 3.0;
  double max_gap_m = 1.6;
  double min_support_m = 0.3;
  bool check_normals = true;  ///< surfaces must look the way their face does: no stairs on curves
};

/// Faces of one direction among surfaces that look that way, the longest first. After each, what
/// lies within twice the band is its own and makes no other.
[[nodiscard]] std::vector<WallFace> straight_runs(const std::vector<SurfacePoint>& surfaces,
                                                  double normal_rad, const RunOptions& options);

/// Sorted numbers in runs: `(first, last)` places in them, where neighbours differ by at most
/// `gap`.
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> runs_of(
    const std::vector<int>& sorted, int gap);

/// The surfaces whose normals lie within an angle of a direction.
[[nodiscard]] std::vector<SurfacePoint> looking(const std::vector<SurfacePoint>& surfaces,
                                                double normal_rad, double within_rad);

}  // namespace roomatlas
