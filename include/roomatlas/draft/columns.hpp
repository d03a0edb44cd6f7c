// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/draft/evidence.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

/// When what stands free is a column of the building.
struct ColumnOptions {
  double thinnest_m = 0.15;
  double thickest_m = 1.2;
  double alike_m = 0.08;   ///< between their sizes
  double nearest_m = 1.8;  ///< between middles; tables stand nearer to each other ...
  double farthest_m = 12.0;
  double spacing_m = 0.12;   ///< ... and less evenly: the middle one of three is this near to where
                             ///< it belongs
  double in_line_deg = 6.0;  ///< of the row, from a side of each
  double least_side_m = 0.1;  ///< of a side that was seen; less says nothing about it
  double round_share = 0.4;   ///< of surfaces that follow two directions; less is round
};

/// Outlines of what stands free, is as thick as columns are, and stands in a row of at least three
/// alike at even distances; one alone may be anything. A side that nobody saw is where it is on
/// one of those that were seen from all sides.
/// @param pieces that stand in rooms
/// @param surfaces what lasers saw
[[nodiscard]] std::vector<Ring> find_columns(const std::vector<PlanFurniture>& pieces,
                                             const std::vector<SurfacePoint>& surfaces,
                                             const ColumnOptions& options);

}  // namespace roomatlas
