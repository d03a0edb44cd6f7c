// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cell_grid.hpp"
#include "roomatlas/plan/floor_plan.hpp"

#include <functional>
#include <vector>

namespace roomatlas::io {

/// One room a label, ascending; its parts are the label's 4-connected regions, the largest first.
/// @param labels 0 where there is no room
/// @param to_world from the grid's corners (cells) to metres
[[nodiscard]] std::vector<PlanRoom> rooms_of_labels(
    const CellGrid<int>& labels, const std::function<Point2(const Point2&)>& to_world);

}  // namespace roomatlas::io
