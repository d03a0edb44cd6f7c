// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/simulated.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace roomatlas {
namespace {

using namespace testing_simulate;

const Drive kFromTheMiddle = {{2, 2}, {2.4, 2}};

/// The first sweep: from the middle of the room, looking along x.
std::vector<float> first_sweep(const FloorPlan& world, const SimulationOptions& options) {
  return run(world, kFromTheMiddle, options).front().reading.ranges_m;
}

TEST(PioneerSonarRing, HasItsRealBearingsClockwiseFromTheLeft) {
  const RangeSensor ring = pioneer_sonar_ring({});
  const std::vector<double> bearings_deg = {90,  50,   30,   10,   -10, -30, -50, -90,
                                            -90, -130, -150, -170, 170, 150, 130, 90};
  ASSERT_EQ(ring.robot_from_beam.size(), bearings_deg.size());
  for (std::size_t i = 0; i < bearings_deg.size(); ++i) {
    EXPECT_NEAR(degrees(ring.robot_from_beam[i].theta_rad), bearings_deg[i], 1e-9) << i;
  }
  EXPECT_EQ(ring.kind, SensorKind::sonar);
  EXPECT_NEAR(degrees(ring.half_cone_rad), 10.0, 1e-9);
  EXPECT_EQ(ring.max_range_m, 5.0);
}

TEST(PioneerSonarRing, StandsOnTheRimOfTheFootprint) {
  SimulationOptions options;
  options.footprint = {0.6, 0.5};
  Box2 rim;
  for (const Pose2& beam : pioneer_sonar_ring(options).robot_from_beam) {
    rim.extend(beam.position());
  }
  EXPECT_NEAR(rim.max.x(), 0.3, 1e-9);
  EXPECT_NEAR(rim.min.x(), -0.3, 1e-9);
  EXPECT_NEAR(rim.max.y(), 0.25, 1e-9);
  EXPECT_NEAR(rim.min.y(), -0.25, 1e-9);
}

TEST(Sonar, MeasuresHandComputedDistancesInASquareRoom) {
  const auto ranges_m = first_sweep(square_room(), exact());
  ASSERT_EQ(ranges_m.size(), 16U);
  EXPECT_NEAR(ranges_m[0], 4.0 - 2.2, 1e-6);                                 // left, at y = 2.2
  EXPECT_NEAR(ranges_m[1], (2.0 - 0.176923) / std::sin(radians(50)), 1e-5);  // the upper wall
  EXPECT_NEAR(ranges_m[3], (2.0 - 0.225) / std::cos(radians(10)), 1e-6);
  EXPECT_NEAR(ranges_m[7], 4.0 - 2.2, 1e-6);
  EXPECT_NEAR(ranges_m[11], (2.0 - 0.225) / std::cos(radians(10)), 1e-6);
}

TEST(Sonar, ReadsTheNearestEchoInsideItsCone) {
  FloorPlan world = square_room();
  // Beam 0 stands at (2.123, 2.2) and looks up; this post is 5.5 to 12.5 degrees beside its axis.
  world.furniture = {{{box(2.20, 3.0, 2.30, 3.1), {}}, FurnitureKind::free_standing}};
  SimulationOptions options = exact();
  EXPECT_NEAR(first_sweep(world, options)[0], 1.8, 1e-6);
  options.sonar_cone_deg = 20.0;
  EXPECT_NEAR(first_sweep(world, options)[0], 0.8 / std::cos(radians(7.5)), 1e-5);
}

TEST(Sonar, HearsNothingFromSurfacesMetAtASlant) {
  SimulationOptions options = exact();  // beam 1 meets the upper wall at 40 degrees
  options.sonar.specular_limit_deg = 41.0;
  EXPECT_NEAR(first_sweep(square_room(), options)[1], 2.38, 0.01);
  options.sonar.specular_limit_deg = 39.0;
  EXPECT_EQ(first_sweep(square_room(), options)[1], 5.0F);
}

TEST(Sonar, NoEchoIsNeverUnderTheMaximumRange) {
  SimulationOptions options = exact();
  options.sonar_max_range_m = 4.7;  // as a float this is under 4.7
  for (const float range_m : first_sweep({}, options)) {
    EXPECT_GE(static_cast<double>(range_m), 4.7);
    EXPECT_NEAR(range_m, 4.7, 1e-6);
  }
}

TEST(Sonar, LosesTheGivenShareOfReadings) {
  SimulationOptions options = exact();
  options.sonar.dropout_share = 0.1;
  options.speed_m_per_s = 0.01;
  double readings = 0.0;
  double lost = 0.0;
  for (const SimulatedStep& step : run(square_room(), kFromTheMiddle, options)) {
    for (const float range_m : step.reading.ranges_m) {
      readings += 1.0;
      if (range_m >= 5.0F) lost += 1.0;
    }
  }
  ASSERT_GT(readings, 6000.0);
  EXPECT_NEAR(lost / readings, 0.1, 4.0 * std::sqrt(0.1 * 0.9 / readings));
}

TEST(Sonar, RangeNoiseHasTheGivenDeviationAndNoMean) {
  SimulationOptions options = exact();
  options.sonar.range_noise_m = 0.03;
  options.speed_m_per_s = 0.001;
  double count = 0.0;
  double sum = 0.0;
  double sum_of_squares = 0.0;
  for (const SimulatedStep& step : run(square_room(), kFromTheMiddle, options)) {
    const double error_m = static_cast<double>(step.reading.ranges_m[0]) - 1.8;  // along the wall
    count += 1.0;
    sum += error_m;
    sum_of_squares += error_m * error_m;
  }
  EXPECT_NEAR(sum / count, 0.0, 4.0 * 0.03 / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(sum_of_squares / count), 0.03, 4.0 * 0.03 / std::sqrt(2.0 * count));
}

}  // namespace
}  // namespace roomatlas
