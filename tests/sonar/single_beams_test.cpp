// SPDX-License-Identifier: GPL-3.0-or-later
// Missions of a laser, corrected as a whole by single beams.
#include "roomatlas/sonar/single_beams.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "support/sonar_world.hpp"

namespace roomatlas {
namespace {

constexpr int kBeams = 16;
constexpr double kDrift_deg_per_m = 2.0;

/// Twice round a square corridor, 1.8 m wide.
const test::DrivenWorld& square_corridor() {
  static const test::DrivenWorld taken = [] {
    auto walls = test::walls_along({{0, 0}, {9, 0}, {9, 7}, {0, 7}}, true);
    const auto inner = test::walls_along({{1.8, 1.8}, {7.2, 1.8}, {7.2, 5.2}, {1.8, 5.2}}, true);
    walls.insert(walls.end(), inner.begin(), inner.end());
    std::vector<Point2> points = {{0.9, 0.9}};
    for (int lap = 0; lap < 2; ++lap) {
      points.insert(points.end(), {{8.1, 0.9}, {8.1, 6.1}, {0.9, 6.1}, {0.9, 0.9}});
    }
    auto mission = test::drive(walls, points, kDrift_deg_per_m, test::laser_of(kBeams));
    SingleBeams beams(mission.readings.size());
    for (RangeReading& reading : mission.readings) reading = beams.of(std::move(reading));
    return mission;
  }();
  return taken;
}

std::vector<Pose2> odometry_of(const std::vector<RangeReading>& readings) {
  std::vector<Pose2> poses;
  for (const RangeReading& reading : readings) poses.push_back(reading.odom_from_robot);
  return poses;
}

/// What comes of sweeps that took no drift out.
const std::optional<SonarTrajectory>& corrected() {
  static const auto found = correct_single_beams(square_corridor().readings,
                                                 odometry_of(square_corridor().readings), {}, {});
  return found;
}

/// Odometry that reports each pose so many readings late.
std::vector<RangeReading> late_by(std::size_t late, std::vector<RangeReading> readings) {
  for (std::size_t i = readings.size() - 1; i >= late; --i) {
    readings[i].odom_from_robot = readings[i - late].odom_from_robot;
  }
  for (std::size_t i = 0; i < late; ++i) {
    readings[i].odom_from_robot = readings.front().odom_from_robot;
  }
  return readings;
}

/// Both trajectories begin at the same pose.
double largest_error_m(const std::vector<Pose2>& poses) {
  double most_m = 0.0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Point2 off = poses[i].position() - square_corridor().truth[i].position();
    most_m = std::max(most_m, off.norm());
  }
  return most_m;
}

/// Readings of a sensor whose ranges tell the number of the beam.
std::vector<RangeReading> numbered(std::size_t beams, std::size_t readings) {
  RangeSensor sensor{SensorKind::laser, {}, 0.0, 500.0};
  std::vector<float> ranges_m;
  for (std::size_t i = 0; i < beams; ++i) {
    sensor.robot_from_beam.push_back({0.1, 0.0, radians(0.5 * static_cast<double>(i))});
    ranges_m.push_back(static_cast<float>(i));
  }
  const auto shared = std::make_shared<const RangeSensor>(sensor);
  return std::vector<RangeReading>(readings, {0.0, {}, shared, ranges_m});
}

TEST(SingleBeams, AreAllOfASweepOfFew) {
  const RangeReading given = numbered(96, 1).front();
  const RangeReading taken = SingleBeams(1000).of(given);
  EXPECT_EQ(taken.ranges_m, given.ranges_m);
  EXPECT_EQ(taken.sensor->kind, SensorKind::sonar);
  EXPECT_EQ(taken.sensor->robot_from_beam, given.sensor->robot_from_beam);
  EXPECT_DOUBLE_EQ(taken.sensor->max_range_m, 500.0);
}

TEST(SingleBeams, LieEvenlyOverASweepOfMore) {
  for (const std::size_t readings : {1U, 4'000U, 17'000U, 50'000U}) {
    const RangeReading given = numbered(361, 1).front();
    const RangeReading taken = SingleBeams(readings).of(given);
    ASSERT_EQ(taken.ranges_m.size(), taken.sensor->robot_from_beam.size());
    EXPECT_LE(taken.ranges_m.size() * readings, 400'000U);
    EXPECT_LE(taken.ranges_m.size(), 96U);
    EXPECT_GE(taken.ranges_m.size(), 7U);
    const float apart = taken.ranges_m[1] - taken.ranges_m[0];
    for (std::size_t i = 0; i < taken.ranges_m.size(); ++i) {
      EXPECT_FLOAT_EQ(taken.ranges_m[i], taken.ranges_m[0] + static_cast<float>(i) * apart);
      EXPECT_EQ(taken.sensor->robot_from_beam[i],
                given.sensor->robot_from_beam[static_cast<std::size_t>(taken.ranges_m[i])]);
    }
    EXPECT_LT(taken.ranges_m.front(), apart);
    EXPECT_GT(taken.ranges_m.back() + apart, 360.0F);
  }
}

TEST(SingleBeams, OfTwoLasersAreEachTheirOwn) {
  SingleBeams beams(4'000);
  const std::vector<RangeReading> wide = numbered(361, 2);
  const std::vector<RangeReading> few = numbered(20, 1);
  const RangeReading first = beams.of(wide[0]);
  const RangeReading other = beams.of(few[0]);
  EXPECT_EQ(other.ranges_m, few[0].ranges_m);
  EXPECT_NE(first.sensor, other.sensor);
  EXPECT_EQ(beams.of(wide[1]).sensor, first.sensor) << "one ring a laser";
}

TEST(SingleBeams, AreOfNoMissionThatIsTooLong) {
  EXPECT_THROW(SingleBeams(0), std::invalid_argument);
  EXPECT_THROW(SingleBeams(50'001), std::invalid_argument);
}

TEST(SingleBeams, ComeOutOfADriftThatTheirSweepsDidNotTakeOut) {
  EXPECT_GT(largest_error_m(odometry_of(square_corridor().readings)), 2.0);
  ASSERT_TRUE(corrected());
  ASSERT_EQ(corrected()->map_from_robot.size(), square_corridor().truth.size());
  EXPECT_LT(largest_error_m(corrected()->map_from_robot), 0.15);
  EXPECT_NEAR(degrees(corrected()->habits.bias_rad_per_m), -kDrift_deg_per_m, 0.2);
  EXPECT_DOUBLE_EQ(corrected()->habits.lag_s, 0.0);
}

TEST(SingleBeams, StayWhereTheirSweepsPutThemWhereOdometryTellsNoLengths) {
  std::vector<RangeReading> readings = square_corridor().readings;
  const std::vector<Pose2> reported = odometry_of(readings);
  for (std::size_t i = 1; i < readings.size(); ++i) {
    Pose2 step = inverse(reported[i - 1]) * reported[i];
    step.x_m *= (i / 40) % 2 == 0 ? 2.0 : 0.3;
    readings[i].odom_from_robot = readings[i - 1].odom_from_robot * step;
  }
  EXPECT_FALSE(correct_single_beams(readings, square_corridor().truth, {}, {}));
}

TEST(SingleBeams, KnowLateOdometryFromTheSweepsTurns) {
  const std::vector<RangeReading> late = late_by(2, square_corridor().readings);
  const auto found = correct_single_beams(late, odometry_of(square_corridor().readings), {}, {});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->habits.lag_s, 0.4, 0.06);
  EXPECT_LT(largest_error_m(found->map_from_robot), 0.25);
}

TEST(SingleBeams, AreTheSameForAnyNumberOfJobs) {
  const std::vector<RangeReading>& readings = square_corridor().readings;
  const auto found = correct_single_beams(readings, odometry_of(readings), {}, {}, {}, 3);
  ASSERT_TRUE(found && corrected());
  EXPECT_EQ(found->map_from_robot, corrected()->map_from_robot);
}

TEST(SingleBeams, NeedAPoseForEachReading) {
  EXPECT_THROW(static_cast<void>(correct_single_beams(square_corridor().readings, {}, {}, {})),
               std::invalid_argument);
  EXPECT_FALSE(correct_single_beams({}, {}, {}, {}));
}

}  // namespace
}  // namespace roomatlas
