// SPDX-License-Identifier: GPL-3.0-or-later
// What was learnt of places. The numbers are printed by `./run bench locate train`.
#pragma once

#include "roomatlas/core/learnt_sum.hpp"
#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

/// Log odds that the likeliest place is right.
[[nodiscard]] const LearntSum& laser_place_is_right();
[[nodiscard]] const LearntSum& sonar_place_is_right();

}  // namespace roomatlas
