// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "roomatlas/core/geometry.hpp"

namespace roomatlas {

/// Drops points that are closer than tau to the last one kept (paper III.D). The first and the
/// last point stay, so that a wall keeps its ends; pinned points stay.
/// @param pinned ascending indices into `points`
/// @returns ascending indices of the points that stay
[[nodiscard]] std::vector<std::size_t> decimate(const Polyline& points, double tau_m,
                                                const std::vector<std::size_t>& pinned = {});

/// Douglas and Peucker 1973 (paper III.D): every point left out lies within `tolerance_m` of the
/// edge that replaces it.
/// @param pinned ascending indices that must stay: the jambs of doors
/// @returns ascending indices of the points that stay; all of them for fewer than three points
[[nodiscard]] std::vector<std::size_t> douglas_peucker(const Polyline& points, double tolerance_m,
                                                       const std::vector<std::size_t>& pinned = {});

}  // namespace roomatlas
