// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/draft/evidence.hpp"

namespace roomatlas {

/// What echoes say of walls that look one way: a wall square to a sonar's axis, or within its cone,
/// is as far away as the echo, at the foot of the perpendicular. Each votes there and 0.1 m to each
/// side. Unlike hits on the axis, such votes have no smear.
/// @param normal_rad of the walls, towards the sonars
[[nodiscard]] std::vector<SurfacePoint> votes_for(double normal_rad,
                                                  const std::vector<Echo>& echoes,
                                                  double half_cone_rad, double max_range_m);

/// The direction modulo 90 degrees for which votes agree best, in [0, pi/2).
[[nodiscard]] double best_direction_rad(const std::vector<Echo>& echoes, double half_cone_rad,
                                        double max_range_m, int jobs);

}  // namespace roomatlas
