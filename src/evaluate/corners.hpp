// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

#include <cstddef>
#include <vector>

namespace roomatlas {

/// Where a boundary turns; walls run on its right, the room lies on its left.
struct Corner {
  Point2 point = Point2::Zero();
  double in_rad = 0.0;   ///< direction of the wall that leads to it
  double out_rad = 0.0;  ///< direction of the wall that leads from it
};

struct CornerOptions {
  double simplify_m = 0.15;   ///< to which boundaries are simplified first: steps are no corners
  double min_turn_rad = 0.5;  ///< a boundary that turns less has no corner there
};

[[nodiscard]] std::vector<Corner> corners_of(const std::vector<Ring>& rings,
                                             const CornerOptions& options);

struct CornerMatch {
  std::size_t ours = 0;
  std::size_t theirs = 0;
  double distance_m = 0.0;
};

/// One to one, nearest first; corners of walls that face opposite ways are no match.
[[nodiscard]] std::vector<CornerMatch> match_corners(const std::vector<Corner>& ours,
                                                     const std::vector<Corner>& theirs,
                                                     double gate_m);

[[nodiscard]] bool same_directions(const Corner& a, const Corner& b, double gate_rad);

}  // namespace roomatlas
