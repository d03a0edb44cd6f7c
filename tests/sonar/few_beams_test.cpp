// SPDX-License-Identifier: GPL-3.0-or-later
// Missions of a laser of few beams, corrected as a whole.
#include "roomatlas/sonar/few_beams.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "support/sonar_world.hpp"

namespace roomatlas {
namespace {

constexpr int kBeams = 16;
constexpr double kDrift_deg_per_m = 2.0;

/// Twice round a square corridor, 1.8 m wide.
const test::DrivenWorld& square_corridor() {
  static const test::DrivenWorld mission = [] {
    auto walls = test::walls_along({{0, 0}, {9, 0}, {9, 7}, {0, 7}}, true);
    const auto inner = test::walls_along({{1.8, 1.8}, {7.2, 1.8}, {7.2, 5.2}, {1.8, 5.2}}, true);
    walls.insert(walls.end(), inner.begin(), inner.end());
    std::vector<Point2> points = {{0.9, 0.9}};
    for (int lap = 0; lap < 2; ++lap) {
      points.insert(points.end(), {{8.1, 0.9}, {8.1, 6.1}, {0.9, 6.1}, {0.9, 0.9}});
    }
    return test::drive(walls, points, kDrift_deg_per_m, test::laser_of(kBeams));
  }();
  return mission;
}

std::vector<Pose2> odometry_of(const std::vector<RangeReading>& readings) {
  std::vector<Pose2> poses;
  for (const RangeReading& reading : readings) poses.push_back(reading.odom_from_robot);
  return poses;
}

/// What comes of sweeps that took no drift out.
const std::optional<SonarTrajectory>& corrected() {
  static const auto found = correct_few_beams(square_corridor().readings,
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

/// As many readings of a sensor that sees nothing.
std::vector<RangeReading> blind(SensorKind kind, std::size_t beams, std::size_t readings) {
  RangeSensor sensor{kind, std::vector<Pose2>(beams), 0.0, 5.0};
  const auto shared = std::make_shared<const RangeSensor>(sensor);
  return std::vector<RangeReading>(readings, {0.0, {}, shared, std::vector<float>(beams, 5.0F)});
}

TEST(FewBeams, AreAtMostSixtyFourOfLasersAlone) {
  EXPECT_TRUE(all_of_few_beams(blind(SensorKind::laser, 64, 2)));
  EXPECT_FALSE(all_of_few_beams(blind(SensorKind::laser, 65, 2)));
  EXPECT_FALSE(all_of_few_beams(blind(SensorKind::sonar, 16, 2)));
  std::vector<RangeReading> mixed = blind(SensorKind::laser, 20, 2);
  mixed.push_back(blind(SensorKind::sonar, 16, 1).front());
  EXPECT_FALSE(all_of_few_beams(mixed));
}

TEST(FewBeams, ComeOutOfADriftThatTheirSweepsDidNotTakeOut) {
  EXPECT_GT(largest_error_m(odometry_of(square_corridor().readings)), 2.0);
  ASSERT_TRUE(corrected());
  ASSERT_EQ(corrected()->map_from_robot.size(), square_corridor().truth.size());
  EXPECT_LT(largest_error_m(corrected()->map_from_robot), 0.15);
  EXPECT_NEAR(degrees(corrected()->habits.bias_rad_per_m), -kDrift_deg_per_m, 0.2);
  EXPECT_DOUBLE_EQ(corrected()->habits.lag_s, 0.0);
}

TEST(FewBeams, StayWhereTheirSweepsPutThemWhereOdometryTellsNoLengths) {
  std::vector<RangeReading> readings = square_corridor().readings;
  const std::vector<Pose2> reported = odometry_of(readings);
  for (std::size_t i = 1; i < readings.size(); ++i) {
    Pose2 step = inverse(reported[i - 1]) * reported[i];
    step.x_m *= (i / 40) % 2 == 0 ? 2.0 : 0.3;
    readings[i].odom_from_robot = readings[i - 1].odom_from_robot * step;
  }
  EXPECT_FALSE(correct_few_beams(readings, square_corridor().truth, {}, {}));
}

TEST(FewBeams, KnowLateOdometryFromTheSweepsTurns) {
  const std::vector<RangeReading> late = late_by(2, square_corridor().readings);
  const auto found = correct_few_beams(late, odometry_of(square_corridor().readings), {}, {});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->habits.lag_s, 0.4, 0.06);
  EXPECT_LT(largest_error_m(found->map_from_robot), 0.25);
}

TEST(FewBeams, AreTheSameForAnyNumberOfJobs) {
  const std::vector<RangeReading>& readings = square_corridor().readings;
  const auto found = correct_few_beams(readings, odometry_of(readings), {}, {}, {}, 3);
  ASSERT_TRUE(found && corrected());
  EXPECT_EQ(found->map_from_robot, corrected()->map_from_robot);
}

TEST(FewBeams, NeedAPoseForEachReadingAndAreLeftInAMissionTooLong) {
  EXPECT_THROW(static_cast<void>(correct_few_beams(square_corridor().readings, {}, {}, {})),
               std::invalid_argument);
  EXPECT_FALSE(correct_few_beams({}, {}, {}, {}));
  const std::size_t many = 50'001;
  const std::vector<Pose2> poses(many);
  EXPECT_FALSE(correct_few_beams(blind(SensorKind::laser, 1, many), poses, {}, {},
                                 [] { FAIL() << "nothing is tried"; }));
}

}  // namespace
}  // namespace roomatlas
