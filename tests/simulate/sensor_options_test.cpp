// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "roomatlas/core/issue.hpp"
#include "simulate/simulated.hpp"

namespace roomatlas {
namespace {

using namespace testing_simulate;

SimulationOptions laser() {
  SimulationOptions options = exact();
  options.sensor = SensorKind::laser;
  options.laser = {0.0, 0.0};
  return options;
}

TEST(SensorOptions, BeamsAreSpreadEvenlyOverTheView) {
  SimulationOptions options = laser();
  options.laser_view_deg = 60.0;
  options.laser_beams = 21;
  const auto beams = range_sensor(options).robot_from_beam;
  ASSERT_EQ(beams.size(), 21U);
  for (std::size_t i = 0; i < 21; ++i) {
    EXPECT_NEAR(degrees(beams[i].theta_rad), -30.0 + 3.0 * static_cast<double>(i), 1e-9);
  }
}

TEST(SensorOptions, BeamsAroundTheWholeCircleAreAllDifferent) {
  SimulationOptions options = laser();
  options.laser_view_deg = 360.0;
  options.laser_beams = 8;
  const auto beams = range_sensor(options).robot_from_beam;
  ASSERT_EQ(beams.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) {
    const double expected_rad = wrap_angle(radians(-180.0 + 45.0 * static_cast<double>(i)));
    EXPECT_NEAR(wrap_angle(beams[i].theta_rad - expected_rad), 0.0, 1e-12);
    EXPECT_GE(beams[i].theta_rad, -kPi);
    EXPECT_LT(beams[i].theta_rad, kPi);
  }
}

TEST(SensorOptions, ASecondLaserIsTheFirstTurnedAboutTheRobotsMiddle) {
  SimulationOptions options = laser();
  options.laser_beams = 31;
  options.laser_view_deg = 200.0;
  options.laser_behind = true;
  const auto beams = range_sensor(options).robot_from_beam;
  ASSERT_EQ(beams.size(), 62U);
  for (std::size_t i = 0; i < 31; ++i) {
    const Pose2 turned = Pose2{0.0, 0.0, -kPi} * beams[i];
    EXPECT_NEAR(beams[31 + i].x_m, turned.x_m, 1e-12);
    EXPECT_NEAR(beams[31 + i].y_m, turned.y_m, 1e-12);
    EXPECT_NEAR(wrap_angle(beams[31 + i].theta_rad - turned.theta_rad), 0.0, 1e-12);
  }
}

TEST(SensorOptions, ARingOfAnySizeHasItsSonarsOnTheRimAndMostlyInFront) {
  SimulationOptions options = exact();
  for (int sonars = 3; sonars <= 16; ++sonars) {
    options.sonars = sonars;
    const auto beams = range_sensor(options).robot_from_beam;
    ASSERT_EQ(beams.size(), static_cast<std::size_t>(sonars));
    const auto in_front = std::count_if(beams.begin(), beams.end(), [](const Pose2& beam) {
      return std::abs(beam.theta_rad) <= radians(90.0) + 1e-9;
    });
    EXPECT_EQ(in_front, sonars < 16 ? std::min(sonars, 8) : 10) << sonars;
    double turned_rad = 0.0;
    for (std::size_t i = 0; i < beams.size(); ++i) {
      EXPECT_LE(std::abs(beams[i].x_m), options.footprint.length_m / 2.0 + 1e-9);
      EXPECT_LE(std::abs(beams[i].y_m), options.footprint.width_m / 2.0 + 1e-9);
      const Pose2& next = beams[(i + 1) % beams.size()];
      double turn_rad = wrap_angle(beams[i].theta_rad - next.theta_rad);
      if (turn_rad < -1e-9) turn_rad += 2.0 * kPi;
      turned_rad += turn_rad;
    }
    EXPECT_NEAR(turned_rad, 2.0 * kPi, 1e-6) << sonars;  // clockwise, once around
  }
}

/// Along a straight wall, 60 m of it.
FloorPlan long_wall() {
  FloorPlan world;
  world.walls = {{box(-5, 2, 65, 2.2), {}}, {box(-5, 4, 65, 4.2), {}}};
  return world;
}

/// A beam that looks at the wall, every few centimetres along it.
std::vector<float> along_the_wall(double silent_share, std::uint64_t seed) {
  SimulationOptions options = laser();
  options.laser.silent_share = silent_share;
  options.seed = seed;
  std::vector<float> ranges_m;
  for (const SimulatedStep& step : run(long_wall(), {{0, 0}, {60, 0}}, options)) {
    ranges_m.push_back(step.reading.ranges_m.back());  // 90 degrees to the left
  }
  return ranges_m;
}

TEST(SilentWalls, OfNoShareAnswerAsEver) {
  for (const float range_m : along_the_wall(0.0, 1)) EXPECT_NEAR(range_m, 2.0F, 1e-6);
}

TEST(SilentWalls, OfFullShareNeverShowTheirFace) {
  for (const float range_m : along_the_wall(1.0, 1)) EXPECT_GT(range_m, 2.1F);
}

TEST(SilentWalls, AreTheGivenShareHalfOfThemBlackAndHalfGlass) {
  double count = 0.0;
  double plain = 0.0;
  double black = 0.0;
  double glass = 0.0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    for (const float range_m : along_the_wall(0.2, seed)) {
      count += 1.0;
      if (range_m < 2.1F) plain += 1.0;
      // Behind glass there is the wall's other face, mostly glass too, and then the next wall.
      else if (range_m >= 8.0F)
        black += 1.0;
      else
        glass += 1.0;
    }
  }
  // 30 stretches a run: a standard deviation of 0.4 / sqrt(900).
  EXPECT_NEAR(plain / count, 0.8, 0.06);
  EXPECT_NEAR(black / count, 0.1, 0.06);  // and glass before a black wall
  EXPECT_NEAR(glass / count, 0.1, 0.06);
}

TEST(SilentWalls, AreStretchesAndNoNoise) {
  const std::vector<float> ranges_m = along_the_wall(0.3, 3);
  int changes = 0;
  for (std::size_t i = 1; i < ranges_m.size(); ++i) {
    if (std::abs(ranges_m[i] - ranges_m[i - 1]) > 0.1F) ++changes;
  }
  EXPECT_GT(changes, 1);
  EXPECT_LT(changes, 62);  // two a stretch at most; there are 1500 readings
}

TEST(SilentWalls, LeaveSonarsAlone) {
  SimulationOptions options = exact();
  const Drive drive = {{0, 0}, {10, 0}};
  const auto plain = run(long_wall(), drive, options);
  options.laser.silent_share = 1.0;
  const auto silent = run(long_wall(), drive, options);
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_EQ(plain[i].reading.ranges_m, silent[i].reading.ranges_m);
  }
}

TEST(SensorOptions, OutOfTheirRangesAreRefused) {
  const Drive drive = {{0, 0}, {1, 0}};
  SimulationOptions options = laser();
  options.sonars = 2;
  EXPECT_THROW((void)run({}, drive, options), UsageError);
  options = laser();
  options.laser_beams = 1;
  EXPECT_THROW((void)run({}, drive, options), UsageError);
  options = laser();
  options.laser_view_deg = 361.0;
  EXPECT_THROW((void)run({}, drive, options), UsageError);
  options = laser();
  options.laser.silent_share = 1.5;
  EXPECT_THROW((void)run({}, drive, options), UsageError);
}

}  // namespace
}  // namespace roomatlas
