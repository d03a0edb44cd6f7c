// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/simulated.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace roomatlas {
namespace {

using namespace testing_simulate;

const Drive kFromTheMiddle = {{2, 2}, {2.4, 2}};

SimulationOptions laser() {
  SimulationOptions options = exact();
  options.sensor = SensorKind::laser;
  options.laser = {0.0, 0.0};
  return options;
}

TEST(Laser, Has181BeamsOfOneDegreeAhead) {
  const RangeSensor sensor = range_sensor(laser());
  ASSERT_EQ(sensor.robot_from_beam.size(), 181U);
  EXPECT_EQ(sensor.kind, SensorKind::laser);
  EXPECT_EQ(sensor.max_range_m, 8.0);
  for (std::size_t i = 0; i < 181; ++i) {
    EXPECT_NEAR(degrees(sensor.robot_from_beam[i].theta_rad), static_cast<double>(i) - 90.0, 1e-9);
  }
}

TEST(Laser, MeasuresHandComputedDistancesAtEveryAngle) {
  const auto ranges_m = run(square_room(), kFromTheMiddle, laser()).front().reading.ranges_m;
  for (int bearing_deg = -90; bearing_deg <= 90; ++bearing_deg) {
    // From (2.1, 2) to the walls x = 4 and y = 0 or 4.
    const double to_side_m = 2.0 / std::max(1e-12, std::abs(std::sin(radians(bearing_deg))));
    const double ahead_m = 1.9 / std::max(1e-12, std::cos(radians(bearing_deg)));
    EXPECT_NEAR(ranges_m[static_cast<std::size_t>(bearing_deg + 90)], std::min(to_side_m, ahead_m),
                1e-5)
        << bearing_deg;
  }
}

TEST(Laser, LosesTheGivenShareOfBeams) {
  SimulationOptions options = laser();
  options.laser.dropout_share = 0.05;
  options.speed_m_per_s = 0.05;
  double beams = 0.0;
  double lost = 0.0;
  for (const SimulatedStep& step : run(square_room(), kFromTheMiddle, options)) {
    for (const float range_m : step.reading.ranges_m) {
      beams += 1.0;
      if (range_m >= 8.0F) lost += 1.0;
    }
  }
  ASSERT_GT(beams, 10000.0);
  EXPECT_NEAR(lost / beams, 0.05, 4.0 * std::sqrt(0.05 * 0.95 / beams));
}

TEST(Laser, RangeNoiseHasTheGivenDeviationAndNoMean) {
  SimulationOptions options = laser();
  options.laser.range_noise_m = 0.02;
  options.speed_m_per_s = 0.001;
  double count = 0.0;
  double sum = 0.0;
  double sum_of_squares = 0.0;
  for (const SimulatedStep& step : run(square_room(), {{2, 2}, {2.2, 2}}, options)) {
    const double error_m = static_cast<double>(step.reading.ranges_m[0]) - 2.0;  // the right wall
    count += 1.0;
    sum += error_m;
    sum_of_squares += error_m * error_m;
  }
  ASSERT_GT(count, 1900.0);
  EXPECT_NEAR(sum / count, 0.0, 4.0 * 0.02 / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(sum_of_squares / count), 0.02, 4.0 * 0.02 / std::sqrt(2.0 * count));
}

TEST(Crosstalk, GivesTheGivenShareOfReadingsTheirNeighboursNearerEcho) {
  SimulationOptions options = exact();
  const auto alone_m = run(square_room(), kFromTheMiddle, options).front().reading.ranges_m;
  // Sonar 1 looks into the corner; both its neighbours look at nearer walls.
  ASSERT_GT(alone_m[1], alone_m[0] + 0.1F);
  ASSERT_GT(alone_m[1], alone_m[2] + 0.1F);
  options.sonar.crosstalk_share = 0.2;
  options.speed_m_per_s = 0.0001;
  double readings = 0.0;
  double changed = 0.0;
  for (const SimulatedStep& step : run(square_room(), {{2, 2}, {2.02, 2}}, options)) {
    const float range_m = step.reading.ranges_m[1];
    readings += 1.0;
    if (range_m > alone_m[1] - 0.05F) continue;
    changed += 1.0;
    EXPECT_LT(std::min(std::abs(range_m - alone_m[0]), std::abs(range_m - alone_m[2])), 0.05F);
  }
  ASSERT_GT(readings, 1500.0);
  EXPECT_NEAR(changed / readings, 0.2, 4.0 * std::sqrt(0.2 * 0.8 / readings));
}

TEST(Corners, AreHeardFromAnglesAtWhichTheirFacesAreNot) {
  FloorPlan world;
  // A square post on its tip: both faces are met at 45 degrees.
  world.walls = {{{{2.0, 0.0}, {2.5, -0.5}, {3.0, 0.0}, {2.5, 0.5}}, {}}};
  SimulationOptions options = exact();
  options.sonar.specular_limit_deg = 30.0;
  const Drive drive = {{0.9, 0.0}, {1.0, 0.0}};
  const auto ahead_m = [&] {
    const auto ranges_m = run(world, drive, options).back().reading.ranges_m;
    return std::min(ranges_m[3], ranges_m[4]);
  };
  options.sonar_cone_deg = 30.0;
  EXPECT_EQ(ahead_m(), 5.0F);
  options.sonar.corner_echo_m = 2.0;
  EXPECT_NEAR(ahead_m(), 1.0 - 0.225, 0.01);
}

}  // namespace
}  // namespace roomatlas
