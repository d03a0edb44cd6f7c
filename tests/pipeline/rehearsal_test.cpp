// SPDX-License-Identifier: GPL-3.0-or-later
// A mission's beginning where odometry errs much, against simulated truth.
#include "rehearsal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "pipeline/three_rounds.hpp"

namespace roomatlas {
namespace {

using namespace test;

SimulationOptions drifting(double bias_deg_per_m, double lag_s) {
  SimulationOptions options;
  options.sensor = SensorKind::laser;
  options.laser_beams = 61;
  options.laser_max_range_m = 5.0;
  options.odometry.heading_bias_deg_per_m = bias_deg_per_m;
  options.faults.lag_s = lag_s;
  return options;
}

/// What is rehearsed of a mission, and after how many readings it was over.
struct Rehearsed {
  LearntOdometry learnt;
  int readings = 0;
};

Rehearsed rehearsed(const SimulationOptions& options) {
  Rehearsal rehearsal{LocalizeOptions{}};
  DeadReckoner reckoner{DriveDirectionOptions{}};
  Rehearsed result;
  for (const MissionEvent& event : three_rounds(options)) {
    const auto* reading = std::get_if<RangeReading>(&event);
    if (reading == nullptr || rehearsal.is_over()) continue;
    for (const DeadReckoned& reckoned : reckoner.add(*reading)) rehearsal.add(reckoned);
    ++result.readings;
  }
  EXPECT_TRUE(rehearsal.is_over());
  result.learnt = rehearsal.learnt();
  return result;
}

/// How far the heading is off at worst in the first room, once turned to be right where it is left.
double bend_of_first_room_deg(const MemoryStore& store) {
  std::map<double, double> true_rad;
  for (const TruePose& pose : store.true_poses) {
    true_rad[pose.timestamp_s] = pose.world_from_robot.theta_rad;
  }
  const std::vector<PathSample>& path = store.asrs.front().path;
  const auto off_rad = [&](const PathSample& sample) {
    return sample.asr_from_robot.theta_rad - true_rad.at(sample.timestamp_s);
  };
  double worst_rad = 0.0;
  for (const PathSample& sample : path) {
    worst_rad = std::max(worst_rad, std::abs(wrap_angle(off_rad(sample) - off_rad(path.back()))));
  }
  return degrees(worst_rad);
}

TEST(Rehearsal, LearnsTheHabitsThatWereSimulated) {
  for (const double bias_deg_per_m : {6.0, -5.0}) {
    const OdometryHabits habits = rehearsed(drifting(bias_deg_per_m, 0.0)).learnt.habits.habits();
    EXPECT_NEAR(degrees(habits.bias_rad_per_m), -bias_deg_per_m, 0.8);
  }
  EXPECT_NEAR(rehearsed(drifting(0.0, 0.4)).learnt.lag.lag_s(), 0.4, 0.1);
}

TEST(Rehearsal, SaysNothingOfOdometryThatErrsLittle) {
  const LearntOdometry learnt = rehearsed(drifting(1.0, 0.0)).learnt;
  EXPECT_EQ(learnt.habits.stretches(), 0);
  EXPECT_EQ(learnt.lag.lag_s(), 0.0);
}

TEST(Rehearsal, IsOverAtTheFirstSonarAndWhereARobotStands) {
  SimulationOptions sonars;
  EXPECT_EQ(rehearsed(sonars).readings, 1);
  Rehearsal standing{LocalizeOptions{}};
  RangeReading reading = std::get<RangeReading>(three_rounds(drifting(0.0, 0.0)).front());
  int readings = 0;
  for (; !standing.is_over() && readings < 10'000; ++readings) {
    reading.timestamp_s += 0.1;
    standing.add({reading, reading.odom_from_robot});
  }
  EXPECT_LT(readings, 5'000);
}

TEST(Rehearsal, FirstRoomIsNotBentByOdometryThatDriftsAndIsLate) {
  EXPECT_LT(bend_of_first_room_deg(mapped(three_rounds(drifting(-6.0, 0.4)))), 1.0);
}

}  // namespace
}  // namespace roomatlas
