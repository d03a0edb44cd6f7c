// SPDX-License-Identifier: GPL-3.0-or-later
// Topics and frames that options name.
#include "io/bags/memory_bag.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace roomatlas::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A robot that drives ahead, with odometry as a topic and in tf, and a localizer's answer.
MemoryBag localized_drive() {
  MemoryBag bag;
  bag.tf(99.0, {{"base_link", "laser", {}}}, "/tf_static");
  for (int i = 0; i < 40; ++i) {
    const double time_s = 100.0 + 0.1 * i;
    bag.tf(time_s, {{"odom", "base_link", {0.1 * i, 0, 0}}, {"map", "odom", {5.0, 0.01 * i, 0}}});
    bag.odometry(time_s, {0.1 * i, 0, 0}).scan(time_s, {});
  }
  return bag;
}

/// What is thrown where one member of the options is set.
std::string refusal_of(std::string RecordingOptions::*member, const std::string& value,
                       const MemoryBag& bag = localized_drive()) {
  MissionOptions options;
  options.recording.*member = value;
  try {
    (void)read_bag(bag, options);
  } catch (const UsageError& error) {
    return std::string("usage: ") + error.what();
  } catch (const InputError& error) {
    return std::string("input: ") + error.what();
  }
  return "";
}

TEST(NamedTopics, WrongNamesAreAnsweredByTheNearest) {
  EXPECT_THAT(refusal_of(&RecordingOptions::scan_topics, "/Scann"),
              HasSubstr("--scan-topic /Scann: no such topic; "
                        "nearest comes /scan;"));
  EXPECT_THAT(refusal_of(&RecordingOptions::scan_topics, "/scan,/nowhere"),
              HasSubstr("--scan-topic /nowhere"));
  EXPECT_THAT(refusal_of(&RecordingOptions::odometry_topic, "/wheel_odom"),
              HasSubstr("nearest comes /odom;"));
  EXPECT_THAT(refusal_of(&RecordingOptions::truth_topic, "tf_statik"),
              HasSubstr("nearest comes /tf_static;"));
  EXPECT_THAT(refusal_of(&RecordingOptions::range_topics, "/scam"),
              HasSubstr("nearest comes /scan;"));
  MemoryBag crowded = localized_drive();
  for (int i = 0; i < 100; ++i) {
    crowded.add("/a" + std::to_string(i), "std_msgs/String", 100.0, std::vector<std::byte>(8));
  }
  crowded.scan(100.0, {}, "/zz/front_laser");
  const std::string said = refusal_of(&RecordingOptions::scan_topics, "/front_laser", crowded);
  EXPECT_THAT(said, HasSubstr("nearest comes /zz/front_laser;"));
  EXPECT_THAT(said, Not(HasSubstr("\n")));
  EXPECT_LT(said.size(), 400U);
}

TEST(NamedTopics, AFrameThatTellsNoOdometryIsRefusedByTheNearest) {
  EXPECT_THAT(refusal_of(&RecordingOptions::odometry_frame, "odon"),
              HasSubstr("--odom-frame odon: neither an odometry topic nor tf tells where the robot "
                        "is in it; nearest comes odom"));
  EXPECT_EQ(refusal_of(&RecordingOptions::odometry_frame, "/odom"), "");
  EXPECT_THAT(refusal_of(&RecordingOptions::base_frame, "base_lnik"),
              HasSubstr("no frame is called so; nearest comes base_link"));
}

TEST(NamedTopics, ALocalizersAnswerIsNoOdometryThoughItIsNamed) {
  const std::string said = refusal_of(&RecordingOptions::odometry_frame, "map");
  EXPECT_THAT(said, HasSubstr("usage: "));
  EXPECT_THAT(said, HasSubstr("--truth-topic tf"));
  // A program that tells the robot's place in the map at once is another matter.
  MemoryBag at_once;
  at_once.tf(99.0, {{"base_link", "laser", {}}}, "/tf_static");
  for (int i = 0; i < 40; ++i) {
    const double time_s = 100.0 + 0.1 * i;
    at_once.tf(time_s, {{"map", "base_link", {0.1 * i, 0, 0}}}).scan(time_s, {});
  }
  MissionOptions options;
  options.recording.odometry_frame = "map";
  EXPECT_EQ(read_bag(at_once, options).info.odometry, "tf map -> base_link");
}

TEST(NamedTopics, ATopicThatIsNamedTwiceIsTakenOnce) {
  MissionOptions options;
  options.recording.scan_topics = "/scan,scan";
  const ReadLog log = read_bag(localized_drive(), options);
  EXPECT_EQ(log.info.recording->choice.find("as one reading"), std::string::npos);
  EXPECT_EQ(log.readings.size(), 40U);
}

TEST(NamedTopics, SonarsThatAreMoreThanARobotCanHaveAreLeftOutAndCounted) {
  MemoryBag bag;
  for (int i = 0; i < 20; ++i) bag.odometry(100.0 + 0.1 * i, {0.1 * i, 0, 0});
  for (int i = 0; i < 600; ++i) {  // 300 sonars, two readings each
    const double time_s = 100.0 + 0.001 * i;
    MessageBytes out(Layout::ros1);
    out.header(time_s, "base_link").add(std::uint8_t{0}).add(0.5F).add(0.1F).add(4.0F).add(1.5F);
    bag.add("/sonar_" + std::to_string(i % 300), "sensor_msgs/Range", time_s, out.bytes);
  }
  const ReadLog log = read_bag(bag);
  ASSERT_EQ(log.readings.size(), 2U);
  EXPECT_EQ(log.readings[0].ranges_m.size(), 256U);
  EXPECT_TRUE(is_told(log, "44 topics of sensor_msgs/Range are left out"));
}

}  // namespace
}  // namespace roomatlas::test
