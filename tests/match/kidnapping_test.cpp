// SPDX-License-Identifier: GPL-3.0-or-later
// A robot that is carried from one drawn room to another, and one that is only shoved.
#include <gtest/gtest.h>

#include "roomatlas/match/kidnapping.hpp"
#include "swept_room.hpp"

namespace roomatlas::test {
namespace {

const WorldDrawing kLargeHall = {"########################################",  //
                                 "#                                      #",  //
                                 "#                 b                    #",  //
                                 "#                                      #",  //
                                 "#                                      #",  //
                                 "#     ##                 ##            #",  //
                                 "#                                      #",  //
                                 "#                                      #",  //
                                 "#   a                                  #",  //
                                 "#                                      #",  //
                                 "#                        ##            #",  //
                                 "#                                      #",  //
                                 "#                                      #",  //
                                 "########################################"};

std::vector<RangeReading> driven(const WorldDrawing& drawing, double noise_m = 0.01) {
  LaserRobot robot;
  robot.noise_m = noise_m;
  return readings_along(surfaces_of(drawing), way_points_of(drawing), robot);
}

/// One log of two drives: odometry goes on as if the robot had only taken `step` between them.
std::vector<RangeReading> one_after_other(std::vector<RangeReading> first,
                                          const std::vector<RangeReading>& second,
                                          const Pose2& step = {}) {
  const RangeReading end = first.back();
  const Pose2 to = end.odom_from_robot * step * inverse(second.front().odom_from_robot);
  const double later_s = end.timestamp_s + 0.1 - second.front().timestamp_s;
  for (RangeReading reading : second) {
    reading.sensor = end.sensor;
    reading.odom_from_robot = to * reading.odom_from_robot;
    reading.timestamp_s += later_s;
    first.push_back(std::move(reading));
  }
  return first;
}

std::vector<Kidnapping> found_in(const std::vector<RangeReading>& readings) {
  KidnappingFinder finder({});
  for (const RangeReading& reading : readings) finder.add(reading);
  return finder.found();
}

TEST(Kidnapping, IsFoundAtTheReadingAfterIt) {
  const auto before = driven(kUnevenRoom);
  const auto log = one_after_other(before, driven(kLargeHall));
  const auto found = found_in(log);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].reading, static_cast<std::int64_t>(before.size()));
  EXPECT_EQ(found[0].before_s, before.back().timestamp_s);
  EXPECT_EQ(found[0].after_s, log[before.size()].timestamp_s);
  EXPECT_LE(found[0].agreement, KidnappingOptions{}.broken_share);
}

TEST(Kidnapping, IsNoOrdinaryDrive) {
  EXPECT_TRUE(found_in(driven(kUnevenRoom)).empty());
  EXPECT_TRUE(found_in(driven(kLargeHall, 0.03)).empty());
}

TEST(Kidnapping, IsNoShoveThatOdometryDidNotNotice) {
  const auto whole = driven(kUnevenRoom);
  const std::size_t half = whole.size() / 2;
  const auto split = whole.begin() + static_cast<std::ptrdiff_t>(half);
  for (const Pose2& shove : {Pose2{0.3, 0.2, radians(20.0)}, Pose2{-0.4, 0.1, radians(-15.0)}}) {
    const auto log = one_after_other({whole.begin(), split}, {split, whole.end()}, shove);
    EXPECT_TRUE(found_in(log).empty()) << shove.x_m;
  }
}

TEST(Kidnapping, IsNoSweepThatSawSomethingElseForAMoment) {
  auto log = driven(kUnevenRoom);
  const RangeReading other = driven(kLargeHall).front();
  const std::size_t middle = log.size() / 2;
  for (std::size_t i = middle; i < middle + 2; ++i) log[i].ranges_m = other.ranges_m;
  EXPECT_TRUE(found_in(log).empty());
}

TEST(Kidnapping, IsNotLookedForInSonars) {
  auto log = one_after_other(driven(kUnevenRoom), driven(kLargeHall));
  auto sonars = std::make_shared<RangeSensor>(*log.front().sensor);
  sonars->kind = SensorKind::sonar;
  for (RangeReading& reading : log) reading.sensor = sonars;
  EXPECT_TRUE(found_in(log).empty());
}

}  // namespace
}  // namespace roomatlas::test
