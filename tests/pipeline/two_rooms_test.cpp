// SPDX-License-Identifier: GPL-3.0-or-later
// From a drawn world to a drawn plan, through the public interface alone.
#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/memory_mission.hpp"
#include "pipeline/three_rounds.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/correct/place.hpp"
#include "roomatlas/pipeline/assemble.hpp"

namespace roomatlas {
namespace {

using namespace test;

const WorldDrawing kTwoRooms = {"###################################",  //
                                "#               #                 #",  //
                                "#               #                 #",  //
                                "#   b       c   #    k        j   #",  //
                                "#               #                 #",  //
                                "#               #                 #",  //
                                "#                                 #",  //
                                "#          df   g    h            #",  //
                                "#                                 #",  //
                                "#               #                 #",  //
                                "#               #                 #",  //
                                "#   a       e   #             i   #",  //
                                "#               #                 #",  //
                                "#               #                 #",  //
                                "###################################"};
const Point2 kDoor(4.95, 2.25);                            ///< in the middle of the wall
const double kAreas[] = {15 * 13 * 0.09, 17 * 13 * 0.09};  ///< of the two rooms

void expect_two_rooms_and_their_door(const std::vector<MissionEvent>& events,
                                     const Pose2& world_from_first, double door_tolerance_m) {
  MemoryStore store = mapped(events);
  const Assembly assembly = assemble(store, {}, {});
  if (!assembly.mapped_again.empty()) store.asrs = assembly.mapped_again;  // of sonars
  const FloorPlan& plan = assembly.plan;
  ASSERT_EQ(plan.rooms.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(plan.rooms[i].area_m2, kAreas[i], 0.2 * kAreas[i]);
  }
  ASSERT_EQ(plan.doors.size(), 1U);
  const Pose2 to_world = world_from_building(place(store, assembly.correction), world_from_first);
  const Segment2& jambs = plan.doors[0].jambs;
  EXPECT_LT((to_world * Point2((jambs.a + jambs.b) / 2.0) - kDoor).norm(), door_tolerance_m);
  EXPECT_NEAR(plan.doors[0].width_m, 0.9, 0.2);
  EXPECT_EQ(plan.doors[0].room_a, plan.rooms[0].id);
  EXPECT_EQ(plan.doors[0].room_b, plan.rooms[1].id);

  std::size_t asrs_in_rooms = 0;
  for (const PlanRoom& room : plan.rooms) asrs_in_rooms += room.asrs.size();
  EXPECT_EQ(asrs_in_rooms, store.asrs.size()) << "each ASR belongs to one room";
  EXPECT_EQ(assembly.room_of_asr.size(), store.asrs.size());
  EXPECT_EQ(assembly.correction.asrs.size(), store.asrs.size());
}

TEST(Pipeline, DrawsTwoRoomsAndTheirDoorFromALaser) {
  LaserRobot robot;
  robot.noise_m = 0.02;
  robot.odom_from_world = {2.0, -3.0, radians(20.0)};
  const auto readings = readings_in(kTwoRooms, robot);
  expect_two_rooms_and_their_door(
      events_of(readings), inverse(robot.odom_from_world) * readings[0].odom_from_robot, 0.3);
}

TEST(Pipeline, DrawsTwoRoomsAndTheirDoorFromARingOfSonars) {
  const auto events = sonar_mission(kTwoRooms);
  // the map is laid on the world by the first pose alone, whose heading sonars do not see well
  expect_two_rooms_and_their_door(events, std::get<TruePose>(events[1]).world_from_robot, 0.4);
}

TEST(Pipeline, GivesTheSamePlanTwice) {
  const MemoryStore store = mapped(events_of(readings_in(kTwoRooms)));
  const Assembly first = assemble(store, {}, {});
  const Assembly second = assemble(store, {}, {});
  ASSERT_EQ(first.plan.rooms.size(), second.plan.rooms.size());
  for (std::size_t i = 0; i < first.plan.rooms.size(); ++i) {
    const PlanRoom& a = first.plan.rooms[i];
    const PlanRoom& b = second.plan.rooms[i];
    EXPECT_EQ(a.label_point, b.label_point);
    ASSERT_EQ(a.parts.size(), b.parts.size());
    for (std::size_t k = 0; k < a.parts.size(); ++k) EXPECT_EQ(a.parts[k].outer, b.parts[k].outer);
  }
  for (std::size_t i = 0; i < first.correction.asrs.size(); ++i) {
    EXPECT_EQ(first.correction.asrs[i].building_from_asr,
              second.correction.asrs[i].building_from_asr);
  }
}

TEST(Pipeline, NeedsNoReadingsInTheStoreToDrawAPlan) {
  MapOptions options;
  options.record.keep_readings = false;
  const MemoryStore store = mapped(events_of(readings_in(kTwoRooms)), options);
  for (const Asr& asr : store.asrs) EXPECT_TRUE(asr.readings.empty());
  EXPECT_EQ(assemble(store, {}, {}).plan.rooms.size(), 2U);
}

TEST(Pipeline, RecognisesDoorwaysWhereReadingsWereNotKept) {
  MapOptions options;
  options.record.keep_readings = false;
  const MemoryStore store = mapped(three_rounds(OdometryPreset::mild), options);
  const auto edges = assemble(store, {}, {}).graph.edges;
  EXPECT_GE(
      std::count_if(edges.begin(), edges.end(),
                    [](const PassageEdge& edge) { return edge.source == EdgeSource::recognised; }),
      5);
}

TEST(Pipeline, TellsOfReadingsThatAreMissing) {
  MemoryStore store = mapped(events_of(readings_in(kTwoRooms)));
  store.asrs.back().readings.resize(1);
  EXPECT_THROW((void)assemble(store, {}, {}), InputError);
}

TEST(Pipeline, AnAnswerThatDoesNotExistIsRefusedWithThoseThatDo) {
  Options options;
  options.assemble.answer = 2;
  try {
    (void)assemble(mapped(events_of(readings_in(kTwoRooms))), {}, options);
    FAIL() << "the mission has one answer";
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(), "--alternative 2: the readings have one answer, 1");
  }
}

TEST(Pipeline, TellsOfClosuresThatHaveNoEffect) {
  Options options;
  options.assemble.closures.without_best = 3;
  const auto is_told = [&](const MemoryStore& store) {
    const Issues issues = assemble(store, {}, options).plan.issues;
    return std::any_of(issues.begin(), issues.end(),
                       [](const Issue& issue) { return issue.field == "closures"; });
  };
  EXPECT_TRUE(is_told(mapped(sonar_mission(kTwoRooms))));
  EXPECT_FALSE(is_told(mapped(events_of(readings_in(kTwoRooms)))));
}

TEST(Pipeline, PlacesOnePoseAReadingWithItsOwnTimestamp) {
  LaserRobot robot;
  robot.start_s = 976052857.256431;  // needs all digits of a double
  const auto readings = readings_in(kTwoRooms, robot);
  const MemoryStore store = mapped(events_of(readings));
  const Correction correction = assemble(store, {}, {}).correction;
  const PlacedMission placed = place(store, correction);
  ASSERT_EQ(placed.odometry.size(), readings.size());
  ASSERT_EQ(placed.corrected.size(), readings.size());
  ASSERT_EQ(placed.path_before.size(), readings.size());
  EXPECT_EQ(placed.walls_before.size(), placed.walls_after.size());
  for (std::size_t i = 0; i < readings.size(); ++i) {
    EXPECT_EQ(placed.odometry[i].timestamp_s, readings[i].timestamp_s);
    EXPECT_EQ(placed.corrected[i].timestamp_s, readings[i].timestamp_s);
    EXPECT_EQ(placed.odometry[i].pose, readings[i].odom_from_robot);
  }
}

TEST(Pipeline, KeepsTimestampsThatStepBack) {
  auto readings = readings_in(kTwoRooms);
  for (std::size_t i = 100; i < 110; ++i) readings[i].timestamp_s -= 50.0;
  const MemoryStore store = mapped(events_of(readings));
  const PlacedMission placed = place(store, assemble(store, {}, {}).correction);
  ASSERT_EQ(placed.corrected.size(), readings.size());
  for (std::size_t i = 0; i < readings.size(); ++i) {
    EXPECT_EQ(placed.corrected[i].timestamp_s, readings[i].timestamp_s);
  }
}

TEST(Pipeline, PlacesThePathRigidlyWithinEachAsr) {
  const MemoryStore store = mapped(sonar_mission(kTwoRooms));
  const PlacedMission placed = place(store, assemble(store, {}, {}).correction);
  std::size_t next = 0;
  for (const Asr& asr : store.asrs) {
    for (std::size_t i = 0; i < asr.path.size(); ++i, ++next) {
      const Pose2 from_first =
          inverse(placed.corrected[next - i].pose) * placed.corrected[next].pose;
      const Pose2 expected = inverse(asr.path[0].asr_from_robot) * asr.path[i].asr_from_robot;
      EXPECT_LT((from_first.position() - expected.position()).norm(), 1e-9);
    }
  }
  EXPECT_EQ(next, placed.corrected.size());
}

}  // namespace
}  // namespace roomatlas
