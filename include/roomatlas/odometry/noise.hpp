// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace roomatlas {

/// A standard deviation that grows with the motion: in metres of a position, in radians of a
/// heading. All parts are at least 0; a part of 0 is none.
struct MotionSigma {
  double still = 0.0;       ///< however short the motion
  double per_m = 0.0;       ///< a metre: of errors that keep their sign along the way
  double per_sqrt_m = 0.0;  ///< a square root of a metre: of errors that change it all the time, a
                            ///< random walk
  double per_rad = 0.0;     ///< a radian turned: of a heading, the share of the turn
};

/// How far odometry's account of a motion is to be believed, once its habits (`OdometryHabits`) are
/// taken out. One type, and one instance for each span of motion that is weighed, since what is
/// left depends on the span and on what it is weighed against:
/// - `LocalizeOptions::odometry`: between two readings, centimetres: jumps and lag, which habits do
///   not hold, and the search's window hangs on it;
/// - `SightingChainOptions::odometry`: over the third of a metre between two nodes of the heading's
///   chain;
/// - the steps of a sonar mission's batch (`src/sonar/sonar_problem.cpp`): over 0.4 m;
/// - `HabitLearner` (`src/odometry/habits.cpp`): over a stretch of a metre, against its match;
/// - `CorrectOptions::odometry`: over a whole room, up to 8 m and more, from one pivot to the next.
struct OdometryNoise {
  MotionSigma position;  ///< m
  MotionSigma heading;   ///< rad
};

/// The parts added up: where they have one cause, or must hold at worst.
/// @param way_m,turn_rad lengths of the way and sizes of the turns, at least 0
[[nodiscard]] double plain_sum(const MotionSigma& sigma, double way_m, double turn_rad);

/// The variance: the parts' squares added up, where they are independent. Parameters as above.
[[nodiscard]] double sum_of_squares(const MotionSigma& sigma, double way_m, double turn_rad);

}  // namespace roomatlas
