// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mission_log.hpp"

#include <gtest/gtest.h>

#include <string>

namespace roomatlas {
namespace {

/// Odometry and a range line of the kind, at the time.
std::string laser_at(int time_s) {
  const std::string t = std::to_string(time_s);
  return "FLASER 3 1.0 2.0 1.5 0 0 0 0 0 0 " + t + " host " + t + "\n";
}
std::string sonar_at(int time_s) {
  const std::string t = std::to_string(time_s);
  return "ODOM 0 0 0 0 0 0 " + t + " host " + t + "\nSONAR 0.5 2 1.0 2.0 0 0 0 0 0 1.5 " + t +
         " host " + t + "\n";
}
std::string sonars(int first_s, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += sonar_at(first_s + i);
  return text;
}

bool all_are(const test::ReadLog& log, SensorKind kind) {
  for (const RangeReading& reading : log.readings) {
    if (reading.sensor->kind != kind) return false;
  }
  return true;
}

bool tells_of(const test::ReadLog& log, const std::string& what) {
  for (const std::string& line : test::texts(log.info.issues)) {
    if (line.find(what) != std::string::npos) return true;
  }
  return false;
}

TEST(OneSensorKind, TakesTheLaserAndCountsTheSonars) {
  const auto log = test::read_text_to_map(sonars(1, 3) + "TRUEPOS 1 2 0 0 0 0 4 host 4\n" +
                                          laser_at(5) + sonars(6, 2) + laser_at(8));
  ASSERT_EQ(log.readings.size(), 2U);
  EXPECT_TRUE(all_are(log, SensorKind::laser));
  EXPECT_EQ(log.true_poses.size(), 1U);
  EXPECT_EQ(log.info.readings, 2);
  EXPECT_TRUE(tells_of(log, "5 sonar readings are left out"));
}

TEST(OneSensorKind, TakesTheSonarsWhereNoLaserBegins) {
  const auto log = test::read_text_to_map(sonars(1, 250) + laser_at(300) + sonars(301, 1));
  ASSERT_EQ(log.readings.size(), 251U);
  EXPECT_TRUE(all_are(log, SensorKind::sonar));
  EXPECT_EQ(log.readings.front().timestamp_s, 1.0);
  EXPECT_EQ(log.readings.back().timestamp_s, 301.0);
  EXPECT_TRUE(tells_of(log, "1 laser readings are left out"));
}

TEST(OneSensorKind, SaysNothingOfOneKindAlone) {
  for (const std::string& text : {sonars(1, 30), laser_at(1) + laser_at(2)}) {
    const auto log = test::read_text_to_map(text);
    EXPECT_FALSE(tells_of(log, "readings are left out"));
    EXPECT_EQ(static_cast<std::int64_t>(log.readings.size()), log.info.readings);
  }
}

}  // namespace
}  // namespace roomatlas
