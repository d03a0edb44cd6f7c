// SPDX-License-Identifier: GPL-3.0-or-later
// Habits of the heading as the store and summary.json have always had them: as what odometry does
// wrong, not as what has to be done about it. The signs are opposite.
#pragma once

#include <cmath>

#include "roomatlas/odometry/habits.hpp"

namespace roomatlas {

struct StoredHabits {
  double drift_rad_per_m = 0.0;     ///< positive turns the path left
  double turns_more_per_rad = 0.0;  ///< share by which turns are reported too large
};

[[nodiscard]] inline StoredHabits stored(const OdometryHabits& habits) {
  // 1 - (1 - 0.04) is not 0.04 in the last digits, and 0 must not become -0
  constexpr double kDigits = 1e12;
  return {0.0 - habits.bias_rad_per_m,
          0.0 + std::round((1.0 - habits.turn_gain) * kDigits) / kDigits};
}

[[nodiscard]] inline OdometryHabits habits_of(const StoredHabits& stored) {
  OdometryHabits habits;
  habits.bias_rad_per_m = 0.0 - stored.drift_rad_per_m;
  habits.turn_gain = 1.0 - stored.turns_more_per_rad;
  return habits;
}

}  // namespace roomatlas
