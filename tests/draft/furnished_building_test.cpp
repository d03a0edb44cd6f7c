// SPDX-License-Identifier: GPL-3.0-or-later
// Furnished worlds: what stands before walls, and leaves that stand open, are no walls.
#include <gtest/gtest.h>

#include <algorithm>

#include "known_poses.hpp"
#include "roomatlas/draft/draft_building.hpp"

namespace roomatlas {
namespace {

struct Furnished {
  test::KnownMission mission;
  DraftedBuilding drafted;
};

/// Simulated and drafted once for all tests.
const Furnished& furnished_rooms() {
  static const Furnished one = [] {
    Furnished result{test::eight_rooms(SensorKind::laser, {}, 3), {}};
    result.drafted = draft_building(result.mission.evidence, {});
    return result;
  }();
  return one;
}

const Door* door_at(const DraftedBuilding& drafted, const PlanDoor& door) {
  const Point2 middle = (door.jambs.a + door.jambs.b) / 2.0;
  const auto found = std::find_if(drafted.doors.begin(), drafted.doors.end(), [&](const Door& one) {
    return (one.frame_from_pivot.position() - middle).norm() < 0.2;
  });
  return found == drafted.doors.end() ? nullptr : &*found;
}

TEST(FurnishedBuilding, RoomsAreThoseOfTheWorldWithoutItsFurniture) {
  const auto& [mission, drafted] = furnished_rooms();
  test::expect_rooms_of(mission.world, drafted, 0.04);
}

TEST(FurnishedBuilding, LeavesStandWhereTheyStoodOpen) {
  const auto& [mission, drafted] = furnished_rooms();
  int open = 0;
  for (const PlanDoor& door : mission.world.doors) {
    const Door* found = door_at(drafted, door);
    ASSERT_NE(found, nullptr) << door.id;
    EXPECT_EQ(found->leaf.has_value(), door.leaf.has_value()) << door.id;
    if (!found->leaf || !door.leaf) continue;
    ++open;
    EXPECT_LT((found->leaf->a - door.leaf->a).norm(), 0.2) << door.id;
    EXPECT_LT((found->leaf->b - door.leaf->b).norm(), 0.2) << door.id;
  }
  EXPECT_GE(open, 4) << "the seed leaves too few doors open to tell anything";
}

TEST(FurnishedBuilding, WhatIsDrawnBehindFurnitureIsInferred) {
  const auto& [mission, drafted] = furnished_rooms();
  double hidden_m = 0.0;
  double claimed_m = 0.0;  // measured, although furniture fills the 0.3 m before it
  for (const PlanEdge& edge : drafted.edges) {
    const Point2 way = edge.line.b - edge.line.a;
    const Point2 inwards = Point2(-way.y(), way.x()).normalized();
    const int steps = static_cast<int>(way.norm() / 0.05);
    for (int i = 0; i < steps; ++i) {
      const Point2 at = edge.line.a + way * ((i + 0.5) / steps);
      const auto is_filled = [&](const PlanFurniture& piece) {
        return contains(piece.outline, at + 0.06 * inwards) &&
               contains(piece.outline, at + 0.3 * inwards);
      };
      const auto& furniture = mission.world.furniture;
      if (!std::any_of(furniture.begin(), furniture.end(), is_filled)) continue;
      hidden_m += 0.05;
      if (edge.evidence == WallEvidence::measured) claimed_m += 0.05;
    }
  }
  EXPECT_GT(hidden_m, 5.0);
  EXPECT_LT(claimed_m, 0.15 * hidden_m) << "of " << hidden_m << " m";
}

/// A wall along y = 0 with a gap from x = 0 to 0.9, on floor of 6 m x 6 m.
Occupancy wall_with_gap() {
  Occupancy occupancy;
  occupancy.frame.cell_m = 0.05;
  const CellBox box{{-60, -60}, {60, 60}};
  for (CellMask* mask : {&occupancy.seen, &occupancy.free, &occupancy.obstacle}) {
    *mask = CellMask(box);
  }
  for_each_cell(box, [&](const Cell& cell) {
    const Point2 at = occupancy.frame.center_of(cell);
    const bool is_wall = std::abs(at.y()) < 0.05 && (at.x() < 0.0 || at.x() > 0.9);
    occupancy.seen.set(cell, true);
    occupancy.free.set(cell, !is_wall);
    occupancy.obstacle.set(cell, is_wall);
  });
  return occupancy;
}

void put(const Segment2& line, Occupancy& occupancy) {
  for_each_cell_on_line(occupancy.frame.cell_of(line.a), occupancy.frame.cell_of(line.b),
                        [&](const Cell& cell) {
                          occupancy.obstacle.set(cell, true);
                          occupancy.free.set(cell, false);
                          return true;
                        });
}

const std::vector<Segment2> kGap = {{{0.05, 0.0}, {0.85, 0.0}}};

TEST(DoorLeaves, ALeafAtAJambIsFoundAtAnyAngle) {
  for (const double turn_deg : {50.0, 75.0, 90.0, 120.0}) {
    const Segment2 leaf{{0.03, 0.05}, Point2(0.03, 0.05) + 0.86 * direction(radians(turn_deg))};
    Occupancy occupancy = wall_with_gap();
    put(leaf, occupancy);
    const std::vector<DoorLeaf> found = find_leaves(kGap, occupancy, {});
    ASSERT_EQ(found.size(), 1U) << turn_deg;
    EXPECT_LT((found[0].line.b - leaf.b).norm(), 0.12) << turn_deg;
    clear_leaves(found, occupancy);
    const Point2 middle = (leaf.a + leaf.b) / 2.0;
    EXPECT_TRUE(occupancy.free.at(occupancy.frame.cell_of(middle))) << turn_deg;
    EXPECT_TRUE(occupancy.obstacle.at(occupancy.frame.cell_of({-0.5, 0.0}))) << "the wall stays";
  }
}

TEST(DoorLeaves, WallsAndCupboardsBesideADoorAreNone) {
  Occupancy longer = wall_with_gap();  // a wall that crosses beside the door
  put({{-0.05, 0.05}, {-0.05, 2.5}}, longer);
  EXPECT_TRUE(find_leaves(kGap, longer, {}).empty());
  Occupancy cupboard = wall_with_gap();  // its side is as long as the door is wide
  for (double x = -0.5; x < 0.0; x += 0.05) put({{x, 0.05}, {x, 0.9}}, cupboard);
  EXPECT_TRUE(find_leaves(kGap, cupboard, {}).empty());
  EXPECT_TRUE(find_leaves(kGap, wall_with_gap(), {}).empty());
}

}  // namespace
}  // namespace roomatlas
