// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "room_shapes.hpp"

#include <cstddef>
#include <utility>
#include <vector>

#include "roomatlas/evaluate/plan_errors.hpp"

namespace roomatlas {

/// How the area of the true rooms is divided among the found ones.
/// @param pairs rooms and true rooms that belong together, as indices, one to one
[[nodiscard]] Segmentation segmentation_of(
    const FloorPlan& plan, const FloorPlan& truth, const Overlaps& overlaps,
    const std::vector<std::pair<std::size_t, std::size_t>>& pairs, double piece_share);

}  // namespace roomatlas
