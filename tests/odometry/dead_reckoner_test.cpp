// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/odometry/dead_reckoner.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace roomatlas {
namespace {

constexpr double kWidthM = 7.0;  // a room from (0, 0) to (7, 5)
constexpr double kHeightM = 5.0;

std::shared_ptr<const RangeSensor> laser() {
  RangeSensor sensor;
  sensor.max_range_m = 30.0;
  for (int deg = -90; deg < 90; ++deg) sensor.robot_from_beam.push_back({0, 0, radians(deg)});
  return std::make_shared<RangeSensor>(sensor);
}

/// Distance from inside the room to its wall.
double range_in_room(const Pose2& beam) {
  const Point2 along = direction(beam.theta_rad);
  const double infinity = std::numeric_limits<double>::infinity();
  const double to_x = along.x() > 0   ? (kWidthM - beam.x_m) / along.x()
                      : along.x() < 0 ? -beam.x_m / along.x()
                                      : infinity;
  const double to_y = along.y() > 0   ? (kHeightM - beam.y_m) / along.y()
                      : along.y() < 0 ? -beam.y_m / along.y()
                                      : infinity;
  return std::min(to_x, to_y);
}

RangeReading reading_at(const Pose2& true_pose, const Pose2& odometry, double timestamp_s) {
  static const auto sensor = laser();
  RangeReading reading{timestamp_s, odometry, sensor, {}};
  for (const Pose2& beam : sensor->robot_from_beam) {
    reading.ranges_m.push_back(static_cast<float>(range_in_room(true_pose * beam)));
  }
  return reading;
}

/// A drive in steps along the robot's x axis; what odometry reports of each step is its own matter.
std::vector<RangeReading> drive(const std::vector<double>& true_steps_m,
                                const std::vector<double>& reported_steps_m) {
  Pose2 truth{2.0, 2.0, 0.3};
  Pose2 odometry;
  std::vector<RangeReading> readings{reading_at(truth, odometry, 0.0)};
  for (std::size_t i = 0; i < true_steps_m.size(); ++i) {
    truth = truth * Pose2{true_steps_m[i], 0.0, 0.0};
    odometry = odometry * Pose2{reported_steps_m[i], 0.0, 0.0};
    readings.push_back(reading_at(truth, odometry, static_cast<double>(i + 1)));
  }
  return readings;
}

struct Result {
  std::vector<DeadReckoned> readings;
  int reversed = 0;
  std::size_t most_waiting = 0;
};

Result reckon(const std::vector<RangeReading>& readings,
              const DriveDirectionOptions& options = {}) {
  DeadReckoner reckoner(options);
  Result result;
  std::size_t given = 0;
  const auto take = [&](std::vector<DeadReckoned> released) {
    for (auto& one : released) result.readings.push_back(std::move(one));
  };
  for (const RangeReading& reading : readings) {
    take(reckoner.add(reading));
    result.most_waiting = std::max(result.most_waiting, ++given - result.readings.size());
  }
  take(reckoner.finish());
  result.reversed = reckoner.drives_reversed();
  return result;
}

std::vector<double> steps(int count, double step_m) {
  return std::vector<double>(static_cast<std::size_t>(count), step_m);
}

std::vector<double> joined(std::vector<double> first, const std::vector<double>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

TEST(DeadReckoner, TurnsRoundADriveThatWentBackwardsAndWasReportedForwards) {
  const auto forth_stop = joined(steps(15, 0.1), steps(2, 0.0));
  const auto truth = joined(forth_stop, steps(12, -0.1));
  const auto reported = joined(forth_stop, steps(12, 0.1));
  const Result result = reckon(drive(truth, reported));
  EXPECT_EQ(result.reversed, 1);
  ASSERT_EQ(result.readings.size(), truth.size() + 1);
  EXPECT_NEAR(result.readings.back().reckoned_from_robot.x_m, 0.3, 1e-9);  // 1.5 - 1.2
  EXPECT_NEAR(result.readings[15].reckoned_from_robot.x_m, 1.5, 1e-9);
}

TEST(DeadReckoner, CountsAsTheWholeMissionDoesWhereBothCanTell) {
  const auto forth_stop = joined(steps(15, 0.1), steps(2, 0.0));
  const auto readings =
      drive(joined(forth_stop, steps(12, -0.1)), joined(forth_stop, steps(12, 0.1)));
  EXPECT_EQ(find_drive_directions(readings, {}).drives_reversed, reckon(readings).reversed);
}

TEST(DeadReckoner, LeavesHonestOdometryAlone) {
  const auto there_and_back = joined(joined(steps(15, 0.1), steps(2, 0.0)), steps(12, -0.1));
  const Result result = reckon(drive(there_and_back, there_and_back));
  EXPECT_EQ(result.reversed, 0);
  for (const DeadReckoned& one : result.readings) {
    EXPECT_NEAR(one.reckoned_from_robot.x_m, one.reading.odom_from_robot.x_m, 1e-9);
  }
}

TEST(DeadReckoner, HandsOutEveryReadingOnceAndInOrder) {
  const Result result = reckon(drive(steps(40, 0.05), steps(40, 0.05)));
  ASSERT_EQ(result.readings.size(), 41U);
  for (std::size_t i = 0; i < result.readings.size(); ++i) {
    EXPECT_EQ(result.readings[i].reading.timestamp_s, static_cast<double>(i));
  }
}

TEST(DeadReckoner, HoldsFewReadingsHoweverLongTheDrive) {
  // standing still while the wheels slip: the readings never decide for either direction
  EXPECT_LE(reckon(drive(steps(400, 0.0), steps(400, 0.04))).most_waiting, 64U);
}

TEST(DeadReckoner, NeedsEvidenceFromEachPairOnAverageHoweverManyThereAre) {
  const auto forth_stop = joined(steps(15, 0.1), steps(2, 0.0));
  const auto truth = joined(forth_stop, steps(12, -0.1));
  const auto reported = joined(forth_stop, steps(12, 0.1));
  const auto readings = drive(truth, reported);
  // what the pairs of the reversed interval say, each by itself; it begins at the last stop
  double sum = 0.0;
  int pairs = 0;
  const DriveDirectionOptions usual;
  for (std::size_t i = 17; i < readings.size(); ++i) {
    for (std::size_t k = i + 1; k < readings.size(); ++k) {
      const double apart_m = 0.1 * static_cast<double>(k - i);
      if (apart_m < usual.min_apart_m || apart_m > usual.max_apart_m) continue;
      sum += reverse_log_odds(readings[i], readings[k], usual);
      ++pairs;
      EXPECT_GT(sum / pairs, 9.0) << "a true reversal is clear";
    }
  }
  DriveDirectionOptions strict;
  strict.stream.flip_log_odds_per_pair = 1000.0;  // more than any pair can give
  EXPECT_EQ(reckon(readings, usual).reversed, 1);
  EXPECT_EQ(reckon(readings, strict).reversed, 0);
}

TEST(DeadReckoner, CannotTellWithoutReturnsAndThenBelievesOdometry) {
  auto readings = drive(steps(10, 0.1), steps(10, 0.1));
  for (RangeReading& reading : readings) {
    std::fill(reading.ranges_m.begin(), reading.ranges_m.end(), 81.0F);
  }
  const Result result = reckon(readings);
  EXPECT_EQ(result.reversed, 0);
  EXPECT_NEAR(result.readings.back().reckoned_from_robot.x_m, 1.0, 1e-9);
}

TEST(ReverseLogOdds, ChangesSignWithTheTrueDirection) {
  const auto forwards = drive({0.3}, {0.3});
  const auto backwards = drive({-0.3}, {0.3});
  EXPECT_LT(reverse_log_odds(forwards[0], forwards[1], {}), -3.0);
  EXPECT_GT(reverse_log_odds(backwards[0], backwards[1], {}), 3.0);
}

}  // namespace
}  // namespace roomatlas
