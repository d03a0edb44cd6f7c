// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "roomatlas/core/geometry.hpp"

namespace roomatlas::bench {

/// What the benchmark compares of a union.
struct UnionResult {
  double seconds = 0.0;  ///< processor time of the union alone, not of building its input
  double area_m2 = 0.0;
  std::size_t polygons = 0;
  std::size_t holes = 0;
};

/// GEOS UnaryUnion.
/// @throws std::runtime_error when a polygon is not valid, or GEOS fails
[[nodiscard]] UnionResult union_by_geos(const std::vector<Polygon>& polygons_m);

/// Clipper 6 (libpolyclipping), non-zero rule, as a flat list of rings: it does not say which hole
/// lies in which polygon.
[[nodiscard]] UnionResult union_by_clipper(const std::vector<Polygon>& polygons_m);

/// Processor seconds of this program so far.
[[nodiscard]] double processor_s();

}  // namespace roomatlas::bench
