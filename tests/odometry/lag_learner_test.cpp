// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/odometry/lag_learner.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/core/pose2.hpp"

namespace roomatlas {
namespace {

/// Heading of a robot that turns for a second every four seconds, now left, now right.
double heading_rad(double time_s) {
  const double turns = std::floor(time_s / 4.0);
  const double part = std::clamp(time_s - 4.0 * turns, 0.0, 1.0);
  const bool is_left = std::fmod(turns, 2.0) == 0.0;
  return is_left ? 0.8 * part : 0.8 * (1.0 - part);
}

struct LateDrive {
  double lag_s = 0.0;
  double gain = 1.0;
  double noise_rad = radians(0.5);  ///< of each matched heading
  double turns = 1.0;               ///< share of the turns that are driven
  double every_s = 0.1;
};

double learnt(const LateDrive& drive) {
  std::mt19937 engine(3);
  std::normal_distribution<double> normal;
  LagLearner learner;
  double before_rad = 0.0;
  for (double time_s = 5.0; time_s < 65.0; time_s += drive.every_s) {
    const double matched_rad = drive.turns * heading_rad(time_s) + drive.noise_rad * normal(engine);
    const double odometry_rad = 3.0 + drive.gain * drive.turns * heading_rad(time_s - drive.lag_s);
    learner.add(time_s, wrap_angle(odometry_rad), matched_rad - before_rad);
    before_rad = matched_rad;
  }
  return learner.lag_s();
}

TEST(LagLearner, FindsByHowMuchOdometryIsLateOrEarly) {
  for (const double lag_s : {-0.3, 0.12, 0.23, 0.48}) EXPECT_NEAR(learnt({lag_s}), lag_s, 0.02);
  EXPECT_NEAR(learnt({.lag_s = 0.3, .gain = 0.95, .noise_rad = radians(1.5)}), 0.3, 0.03);
}

TEST(LagLearner, FindsNoneWhereThereIsNone) {
  for (const double noise_deg : {0.0, 0.5, 2.0}) {
    EXPECT_EQ(learnt({.gain = 1.04, .noise_rad = radians(noise_deg)}), 0.0);
  }
}

TEST(LagLearner, SaysNothingOfWhatItCannotTell) {
  EXPECT_EQ(learnt({.lag_s = 0.3, .turns = 0.0}), 0.0);
  EXPECT_EQ(learnt({.lag_s = 0.3, .every_s = 1.0}), 0.0) << "readings too far apart";
}

}  // namespace
}  // namespace roomatlas
