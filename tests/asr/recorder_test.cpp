// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/asr/recorder.hpp"

#include <gtest/gtest.h>

#include "asr/recorded.hpp"

namespace roomatlas {
namespace {

using namespace test;

const WorldDrawing kThreeRooms = {"#############################################",  //
                                  "#              #             #              #",  //
                                  "#              #             #              #",  //
                                  "#              #     cd      #              #",  //
                                  "#              #             #              #",  //
                                  "#                                           #",  //
                                  "#    a             b    e             f     #",  //
                                  "#                                           #",  //
                                  "#              #             #              #",  //
                                  "#              #             #              #",  //
                                  "#              #             #              #",  //
                                  "#              #             #              #",  //
                                  "#############################################"};
/// Where the walls with the doors have their middles.
const Point2 kFirstDoor(4.65, 1.95);
const Point2 kSecondDoor(8.85, 1.95);

LaserRobot robot_elsewhere() {
  LaserRobot robot;
  robot.odom_from_world = {12.0, -5.0, radians(33.0)};
  return robot;
}

std::vector<Asr> three_rooms() { return recorded(readings_in(kThreeRooms, robot_elsewhere()), {}); }

TEST(Recorder, MakesOneAsrOfEachRoom) {
  const std::vector<Asr> asrs = three_rooms();
  ASSERT_EQ(asrs.size(), 3U);
  for (std::size_t i = 0; i < asrs.size(); ++i) {
    EXPECT_EQ(asrs[i].id, static_cast<AsrId>(i + 1));
    EXPECT_EQ(asrs[i].exits.size(), i == 1 ? 2U : 1U);
    for (const Exit& exit : asrs[i].exits) EXPECT_EQ(exit.kind, PassageKind::doorway);
    EXPECT_FALSE(asrs[i].walls.empty());
    EXPECT_TRUE(contains(asrs[i].outline_asr, asrs[i].reference_point_asr));
  }
}

TEST(Recorder, PutsThePivotsIntoTheDoors) {
  const std::vector<Asr> asrs = three_rooms();
  ASSERT_EQ(asrs.size(), 3U);
  const Pose2 world_from_odom = inverse(robot_elsewhere().odom_from_world);
  for (const auto& [asr, door] : {std::pair(asrs[1], kFirstDoor), {asrs[2], kSecondDoor}}) {
    const Pose2 world_from_asr = world_from_odom * asr.odom_from_asr;
    EXPECT_NEAR(world_from_asr.x_m, door.x(), 0.3) << "in the wall or at its face";
    EXPECT_NEAR(world_from_asr.y_m, door.y(), 0.1);
    EXPECT_LE(std::abs(degrees(world_from_asr.theta_rad)), 20.0) << "x points into the room";
    EXPECT_NEAR(asr.exits[0].width_m, 0.9, 0.15);
  }
}

TEST(Recorder, JoinsEachAsrToTheNextAtTheSameDoorwaySeenFromTheOtherSide) {
  expect_joined(three_rooms());
}

TEST(Recorder, GivesEachReadingToExactlyOneAsrInOrder) {
  const auto readings = readings_in(kThreeRooms, robot_elsewhere());
  expect_all_once_in_order(recorded(readings, {}), readings);
}

TEST(Recorder, ComposesPosesBackToOdometry) { expect_composes_to_odometry(three_rooms(), 1e-9); }

TEST(Recorder, StartsTheFirstAsrAtTheRobotsFirstPose) {
  const auto readings = readings_in(kThreeRooms, robot_elsewhere());
  const std::vector<Asr> asrs = recorded(readings, {});
  ASSERT_FALSE(asrs.empty());
  EXPECT_EQ(asrs[0].odom_from_asr, readings[0].odom_from_robot);
  EXPECT_EQ(asrs[0].path[0].asr_from_robot, Pose2{});
}

TEST(Recorder, LeavesReadingsOutWhenToldAndNothingElse) {
  RecorderOptions options;
  options.keep_readings = false;
  const auto readings = readings_in(kThreeRooms, robot_elsewhere());
  const std::vector<Asr> without = recorded(readings, options);
  const std::vector<Asr> with = recorded(readings, {});
  ASSERT_EQ(without.size(), with.size());
  for (std::size_t i = 0; i < with.size(); ++i) {
    EXPECT_TRUE(without[i].readings.empty());
    EXPECT_EQ(with[i].readings.size(), with[i].path.size());
    EXPECT_EQ(without[i].path.size(), with[i].path.size());
    EXPECT_EQ(without[i].outline_asr.outer, with[i].outline_asr.outer);
  }
}

TEST(Recorder, HandsNothingOverForAMissionWithoutReadings) {
  MemoryStore store;
  AsrRecorder recorder({}, {}, store);
  recorder.finish();
  EXPECT_TRUE(store.asrs.empty());
  EXPECT_EQ(recorder.asrs_written(), 0);
}

TEST(Recorder, MakesOneAsrOfASingleReading) {
  auto readings = readings_in(kThreeRooms);
  readings.resize(1);
  const std::vector<Asr> asrs = recorded(readings, {});
  ASSERT_EQ(asrs.size(), 1U);
  EXPECT_EQ(asrs[0].path.size(), 1U);
  EXPECT_TRUE(asrs[0].exits.empty());
}

}  // namespace
}  // namespace roomatlas
