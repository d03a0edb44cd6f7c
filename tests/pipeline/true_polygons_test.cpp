// SPDX-License-Identifier: GPL-3.0-or-later
// The plan of a world's own polygons is that world: walls made regular change no area and no door,
// and walls that are slanted or curved are not bent.
#include <gtest/gtest.h>

#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/merge/regular_walls.hpp"
#include "support/shipped_world.hpp"

namespace roomatlas {
namespace {

constexpr const char* kWorlds[] = {"two_rooms",       "eight_rooms",        "nine_rooms",
                                   "identical_rooms", "slanted_and_curved", "open_hall",
                                   "afit_floor"};

/// The world's rooms, turned, so that no wall lies along an axis by itself.
struct Turned {
  Pose2 turn{3.0, -7.0, radians(17.0)};
  std::vector<PlacedOutline> outlines;
  std::vector<Door> doors;
};

Turned turned(const FloorPlan& world) {
  Turned result;
  for (const PlanRoom& room : world.rooms) {
    for (const Polygon& part : room.parts) {
      result.outlines.push_back({room.id, room.id, transformed(result.turn, part)});
    }
  }
  for (const PlanDoor& door : world.doors) {
    result.doors.push_back(door_between({result.turn * door.jambs.a, result.turn * door.jambs.b},
                                        door.room_a, door.room_b));
  }
  return result;
}

class TruePolygons : public testing::TestWithParam<const char*> {};

TEST_P(TruePolygons, GiveTheirOwnPlan) {
  const FloorPlan world = test::shipped_world(GetParam());
  const Turned from = turned(world);
  const RegularOutlines regular = with_regular_walls(from.outlines, from.doors, {});
  const FloorPlan plan = merge(regular.outlines, regular.doors, {});
  ASSERT_EQ(plan.rooms.size(), world.rooms.size());
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
    EXPECT_NEAR(plan.rooms[i].area_m2, world.rooms[i].area_m2, 0.01 * world.rooms[i].area_m2)
        << "room " << world.rooms[i].id;
  }
  ASSERT_EQ(plan.doors.size(), world.doors.size());
  for (const PlanDoor& door : world.doors) {
    const Point2 middle = from.turn * Point2((door.jambs.a + door.jambs.b) / 2.0);
    const auto found =
        std::find_if(plan.doors.begin(), plan.doors.end(), [&](const PlanDoor& other) {
          return ((other.jambs.a + other.jambs.b) / 2.0 - middle).norm() < 0.05;
        });
    ASSERT_NE(found, plan.doors.end()) << "door " << door.id;
    EXPECT_NEAR(found->width_m, door.width_m, 0.05);
    EXPECT_EQ(found->room_a, door.room_a);
    EXPECT_EQ(found->room_b, door.room_b);
  }
}

TEST_P(TruePolygons, KeepTheirWalls) {
  const Turned from = turned(test::shipped_world(GetParam()));
  const RegularOutlines regular = with_regular_walls(from.outlines, from.doors, {});
  for (std::size_t i = 0; i < from.outlines.size(); ++i) {
    const Ring& before = from.outlines[i].outline.outer;
    const Ring& after = regular.outlines[i].outline.outer;
    for (std::size_t k = 0; k < before.size(); ++k) {
      const Point2& next = before[(k + 1) % before.size()];
      for (double share = 0.0; share < 1.0; share += 0.25) {
        const Point2 on_wall = before[k] + share * (next - before[k]);
        EXPECT_LT(distance_to_boundary(after, on_wall), 0.02) << "room " << from.outlines[i].room;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OfEachWorld, TruePolygons, testing::ValuesIn(kWorlds));

}  // namespace
}  // namespace roomatlas
