// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mission_log.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace roomatlas {
namespace {

struct Place {
  double x_m;
  double y_m;
  double theta_rad;
};

/// A scan a tenth of a second at each place.
test::ReadLog scans_at(const std::vector<Place>& places, double step_s = 0.1) {
  std::string text;
  double time_s = 100.0;
  for (const Place& at : places) {
    const std::string pose =
        std::to_string(at.x_m) + " " + std::to_string(at.y_m) + " " + std::to_string(at.theta_rad);
    text += "FLASER 3 1.0 2.0 1.5 " + pose + " " + pose + " " + std::to_string(time_s) + " host " +
            std::to_string(time_s) + "\n";
    time_s += step_s;
  }
  return test::read_text_to_map(text);
}

bool is_told(const test::ReadLog& log) {
  for (const std::string& line : test::texts(log.info.issues)) {
    if (line.find("odometry: jumps") != std::string::npos) return true;
  }
  return false;
}

TEST(OdometryJumps, GoOnFromWhereItWas) {
  const auto log = scans_at({{1.0, 2.0, 0.0},
                             {1.1, 2.0, 0.1},
                             {2000.1, -7.0, 0.1},
                             {2000.2, -7.0, 0.1},
                             {2000.2, -6.9, 1.5}});
  ASSERT_EQ(log.readings.size(), 5U);
  EXPECT_NEAR(log.readings[2].odom_from_robot.x_m, 1.1, 1e-6);
  EXPECT_NEAR(log.readings[2].odom_from_robot.y_m, 2.0, 1e-6);
  EXPECT_NEAR(log.readings[4].odom_from_robot.x_m, 1.2, 1e-6);
  EXPECT_NEAR(log.readings[4].odom_from_robot.y_m, 2.1, 1e-6);
  EXPECT_NEAR(log.readings[4].odom_from_robot.theta_rad, 1.5, 1e-6);
  EXPECT_NEAR(log.info.path_length_m, 0.3, 1e-3);
  EXPECT_TRUE(is_told(log));
}

TEST(OdometryJumps, AreNotWaysAcrossAGapOfTheLog) {
  const auto log = scans_at({{1.0, 0.0, 0.0}, {31.0, 0.0, 0.0}}, 10.0);
  ASSERT_EQ(log.readings.size(), 2U);
  EXPECT_NEAR(log.readings[1].odom_from_robot.x_m, 31.0, 1e-6);
  EXPECT_FALSE(is_told(log));
}

}  // namespace
}  // namespace roomatlas
