// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

/// The mission as a robot with a ring of sonars would have recorded it: each laser is replaced by
/// those cones of 20 degrees of the Pioneer's ring that it sees (front: +-10, +-30, +-50, +-90
/// degrees; the same behind), each with the least range of the beams inside. A front laser gives
/// the 8 of the front, a laser all around 16. Sonars and true poses pass unchanged.
/// @param max_range_m ranges at or beyond it are no echo
[[nodiscard]] std::unique_ptr<MissionSource> as_sonar(std::unique_ptr<MissionSource> mission,
                                                      const AsSonarOptions& options,
                                                      double max_range_m);

}  // namespace roomatlas
