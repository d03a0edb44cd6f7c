// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/draft_building.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "known_poses.hpp"

namespace roomatlas {
namespace {

/// The drafted room over a place of the world; null where there is none.
const DraftedRoom* room_at(const DraftedBuilding& drafted, const Point2& at) {
  const auto found =
      std::find_if(drafted.rooms.begin(), drafted.rooms.end(),
                   [&](const DraftedRoom& room) { return contains(room.outline, at); });
  return found == drafted.rooms.end() ? nullptr : &*found;
}

const Door* door_near(const DraftedBuilding& drafted, const Point2& at) {
  const auto near = std::min_element(drafted.doors.begin(), drafted.doors.end(),
                                     [&](const Door& a, const Door& b) {
                                       return (a.frame_from_pivot.position() - at).norm() <
                                              (b.frame_from_pivot.position() - at).norm();
                                     });
  return near == drafted.doors.end() ? nullptr : &*near;
}

void expect_world(const DraftedBuilding& drafted, const FloorPlan& world,
                  const Pose2& building_from_world, double area_share, double jamb_m) {
  EXPECT_EQ(drafted.rooms.size(), world.rooms.size());
  for (const PlanRoom& room : world.rooms) {
    const DraftedRoom* found = room_at(drafted, building_from_world * room.label_point);
    ASSERT_NE(found, nullptr) << room.name;
    EXPECT_NEAR(area(found->outline), room.area_m2, area_share * room.area_m2) << room.name;
  }
  EXPECT_EQ(drafted.doors.size(), world.doors.size());
  for (const PlanDoor& door : world.doors) {
    const Point2 middle = building_from_world * Point2((door.jambs.a + door.jambs.b) / 2.0);
    const Door* found = door_near(drafted, middle);
    ASSERT_NE(found, nullptr) << door.id;
    EXPECT_NEAR(found->width_m, door.width_m, 2.0 * jamb_m) << door.id;
    EXPECT_LT((found->frame_from_pivot.position() - middle).norm(), 0.1 + jamb_m) << door.id;
  }
}

/// Simulated once for all tests that only look at it.
const test::KnownMission& laser_mission() {
  static const test::KnownMission mission = test::eight_rooms(SensorKind::laser, {});
  return mission;
}

TEST(DraftBuilding, DrawsTheWorldFromALasersReadings) {
  const test::KnownMission& mission = laser_mission();
  expect_world(draft_building(mission.evidence, {}), mission.world, {}, 0.01, 0.03);
}

TEST(DraftBuilding, DrawsATurnedWorldAlike) {
  const Pose2 turned{3.7, -2.3, 0.61};
  const test::KnownMission mission = test::eight_rooms(SensorKind::laser, turned);
  expect_world(draft_building(mission.evidence, {}), mission.world, turned, 0.01, 0.03);
}

TEST(DraftBuilding, DrawsTheWorldFromSonarsReadings) {
  const test::KnownMission mission = test::eight_rooms(SensorKind::sonar, {});
  // This drive keeps to doors' axes: three far walls are heard at flat angles alone.
  expect_world(draft_building(mission.evidence, {}), mission.world, {}, 0.09, 0.08);
}

TEST(DraftBuilding, SaysTheSameTwice) {
  const test::KnownMission& mission = laser_mission();
  const DraftedBuilding once = draft_building(mission.evidence, {});
  const DraftedBuilding again = draft_building(mission.evidence, {});
  ASSERT_EQ(once.rooms.size(), again.rooms.size());
  for (std::size_t i = 0; i < once.rooms.size(); ++i) {
    EXPECT_EQ(once.rooms[i].outline.outer, again.rooms[i].outline.outer);
  }
  ASSERT_EQ(once.edges.size(), again.edges.size());
}

TEST(DraftBuilding, EdgesGoAroundEachRoomAndMostAreMeasured) {
  const test::KnownMission& mission = laser_mission();
  const DraftedBuilding drafted = draft_building(mission.evidence, {});
  for (const DraftedRoom& room : drafted.rooms) {
    double all_m = 0.0;
    double measured_m = 0.0;
    for (const PlanEdge& edge : drafted.edges) {
      if (edge.room != room.id) continue;
      all_m += (edge.line.b - edge.line.a).norm();
      if (edge.evidence != WallEvidence::measured) continue;
      measured_m += (edge.line.b - edge.line.a).norm();
      if ((edge.line.b - edge.line.a).norm() < 0.6) continue;
      ASSERT_TRUE(edge.deviation_m.has_value());
      EXPECT_LT(*edge.deviation_m, 0.05);
    }
    double around_m = length(room.outline.outer) +
                      (room.outline.outer.back() - room.outline.outer.front()).norm();
    for (const Ring& hole : room.outline.holes) {
      around_m += length(hole) + (hole.back() - hole.front()).norm();
    }
    EXPECT_NEAR(all_m, around_m, 1e-6);
    EXPECT_GT(measured_m, 0.7 * all_m) << room.id;
  }
}

TEST(DraftBuilding, NothingSeenIsNoBuilding) {
  const DraftedBuilding drafted = draft_building(BuildingEvidence{}, {});
  EXPECT_TRUE(drafted.rooms.empty());
  EXPECT_TRUE(drafted.doors.empty());
}

}  // namespace
}  // namespace roomatlas
