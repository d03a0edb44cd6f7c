// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/simulate/furnish.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "roomatlas/core/issue.hpp"
#include "roomatlas/simulate/world.hpp"
#include "simulate/furnished_world.hpp"

namespace roomatlas::testing_simulate {
namespace {

constexpr std::uint64_t kSeeds = 6;

std::vector<FloorPlan> furnished_offices(const FurnishOptions& options = {}) {
  std::vector<FloorPlan> worlds;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    worlds.push_back(furnished(offices(), seed, options));
  }
  return worlds;
}

/// Points inside a ring, some of them near its edges.
std::vector<Point2> points_in(const Ring& ring) {
  constexpr int kSteps = 12;
  const Box2 box = bounds(ring);
  std::vector<Point2> points;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const Point2 at = box.min + Point2(box.size().x() * i, box.size().y() * j) / kSteps;
      if (contains(ring, at) && distance_to_boundary(ring, at) > 0.002) points.push_back(at);
    }
  }
  return points;
}

std::string text_of(const FloorPlan& world) {
  std::string text;
  const auto add = [&](const Point2& point) {
    text += std::to_string(point.x()) + " " + std::to_string(point.y()) + "\n";
  };
  for (const PlanFurniture& piece : world.furniture) {
    text += to_string(piece.kind);
    for (const Point2& corner : piece.outline.outer) add(corner);
  }
  for (const PlanDoor& door : world.doors) {
    if (!door.leaf) continue;
    add(door.leaf->a);
    add(door.leaf->b);
  }
  return text;
}

/// Of the pieces with that many square metres or more.
std::size_t pieces_from(const FloorPlan& world, double least_m2) {
  return static_cast<std::size_t>(
      std::count_if(world.furniture.begin(), world.furniture.end(),
                    [&](const auto& piece) { return area(piece.outline) >= least_m2; }));
}

TEST(Furnish, RoomsHoldCupboardsTablesChairsAndOpenDoors) {
  std::size_t doors = 0;
  std::size_t open = 0;
  for (const FloorPlan& world : furnished_offices()) {
    const auto against_wall =
        std::count_if(world.furniture.begin(), world.furniture.end(),
                      [](const auto& piece) { return piece.kind == FurnitureKind::against_wall; });
    EXPECT_GE(against_wall, 5);
    EXPECT_GE(pieces_from(world, 0.5), 8U);                           // desks, tables, rows
    EXPECT_GE(world.furniture.size(), pieces_from(world, 0.5) + 8U);  // chairs, legs, boxes
    doors += world.doors.size();
    open += open_leaves(world).size();
  }
  EXPECT_NEAR(static_cast<double>(open) / static_cast<double>(doors), 0.6, 0.25);
}

TEST(Furnish, TheSameSeedGivesTheSameAndAnotherAnother) {
  const FloorPlan first = furnished(offices(), 7, {});
  EXPECT_EQ(text_of(first), text_of(furnished(offices(), 7, {})));
  EXPECT_NE(text_of(first), text_of(furnished(offices(), 8, {})));
}

TEST(Furnish, NoPieceStandsInAWallAnotherPieceOrALeaf) {
  for (const FloorPlan& world : furnished_offices()) {
    std::vector<Polygon> bodies = outlines_of(world.furniture);
    for (const Polygon& leaf : open_leaves(world)) bodies.push_back(leaf);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const auto points = points_in(bodies[i].outer);
      ASSERT_FALSE(points.empty());
      for (const Point2& at : points) {
        EXPECT_FALSE(is_in_any(world.walls, at)) << i << " at " << at.transpose();
        for (std::size_t other = 0; other < bodies.size(); ++other) {
          if (other == i) continue;
          EXPECT_FALSE(contains(bodies[other], at)) << i << " in " << other;
        }
      }
    }
  }
}

TEST(Furnish, EveryPieceStandsInARoomAndClearOfDoors) {
  for (const FloorPlan& world : furnished_offices()) {
    for (const PlanFurniture& piece : world.furniture) {
      const auto points = points_in(piece.outline.outer);
      EXPECT_TRUE(std::any_of(world.rooms.begin(), world.rooms.end(), [&](const PlanRoom& room) {
        return std::all_of(points.begin(), points.end(),
                           [&](const Point2& at) { return is_in_any(room.parts, at); });
      }));
      for (const PlanDoor& door : world.doors) {
        for (const Point2& at : points) EXPECT_GE(distance(door.jambs, at), 1.1);
      }
    }
  }
}

TEST(Furnish, PiecesAgainstAWallTouchItOrStandOffByThreeCentimetres) {
  std::set<int> gaps_cm;
  for (const FloorPlan& world : furnished_offices()) {
    for (const PlanFurniture& piece : world.furniture) {
      if (piece.kind != FurnitureKind::against_wall) continue;
      double gap_m = 1.0;
      for (const Point2& corner : piece.outline.outer) {
        for (const Polygon& wall : world.walls) gap_m = std::min(gap_m, distance_to(wall, corner));
      }
      EXPECT_LT(gap_m, 0.0301);
      gaps_cm.insert(static_cast<int>(std::lround(100.0 * gap_m)));
    }
  }
  EXPECT_TRUE(gaps_cm.contains(0) && gaps_cm.contains(3));
}

TEST(Furnish, LeavesHangAtAJambAndStandOpenBy60To120Degrees) {
  for (const FloorPlan& world : furnished_offices()) {
    for (const PlanDoor& door : world.doors) {
      if (!door.leaf) continue;
      const bool at_a = (door.leaf->a - door.jambs.a).norm() < (door.leaf->a - door.jambs.b).norm();
      const Point2& jamb = at_a ? door.jambs.a : door.jambs.b;
      const Point2 closed = (at_a ? door.jambs.b : door.jambs.a) - jamb;
      const Point2 open = door.leaf->b - door.leaf->a;
      EXPECT_LT((door.leaf->a - jamb).norm(), 0.2);
      EXPECT_NEAR(open.norm(), door.width_m, 0.05);
      const double angle_rad = std::acos(open.dot(closed) / open.norm() / closed.norm());
      EXPECT_GE(degrees(angle_rad), 60.0 - 1e-6);
      EXPECT_LE(degrees(angle_rad), 120.0 + 1e-6);
    }
  }
}

TEST(Furnish, WhatCouldBeReachedBeforeCanStillBeReached) {
  const RobotFootprint footprint;
  const double turning_m = std::hypot(footprint.length_m, footprint.width_m) / 2.0;
  const Point2 start = middle_of(offices().doors.front());
  // A little more before than after, because the raster is another than the tool's.
  const auto flooded = [&](const std::vector<Polygon>& bodies, double radius_m) {
    return reached(start, [&](const Point2& at) { return clearance_m(bodies, at) >= radius_m; });
  };
  const Cells before = flooded(all_bodies(offices()), turning_m + 0.03);
  for (const FloorPlan& world : furnished_offices()) {
    const std::vector<Polygon> bodies = all_bodies(world);
    const Cells after = flooded(bodies, turning_m - 0.03);
    std::size_t lost = 0;
    std::size_t kept = 0;
    for (const auto& cell : before) {
      if (clearance_m(bodies, place_of(cell)) < turning_m + 0.03) continue;
      ++(after.contains(cell) ? kept : lost);
    }
    EXPECT_EQ(lost, 0U);
    EXPECT_GT(kept, before.size() / 4);
  }
}

/// How many of the other doors a way leads to from the first, at least `half_way_m` from furniture.
std::size_t doors_joined(const FloorPlan& world, double half_way_m) {
  const std::vector<Polygon> furniture = outlines_of(world.furniture);
  FloorPlan empty = world;
  empty.furniture.clear();
  const std::vector<Polygon> rest = all_bodies(empty);
  const Cells cells = reached(middle_of(world.doors.front()), [&](const Point2& at) {
    return clearance_m(rest, at) >= 0.27 && clearance_m(furniture, at) >= half_way_m;
  });
  return static_cast<std::size_t>(
      std::count_if(world.doors.begin() + 1, world.doors.end(),
                    [&](const auto& door) { return cells.contains(cell_at(middle_of(door))); }));
}

TEST(Furnish, WaysOf90CentimetresJoinAllDoorsAndNarrowOnesWhereLessIsAskedFor) {
  FurnishOptions careless;
  careless.way_width_m = 0.0;
  careless.amount = 10.0;
  FurnishOptions careful = careless;
  careful.way_width_m = 0.9;
  std::size_t narrow = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    EXPECT_EQ(doors_joined(furnished(offices(), seed, careful), 0.42), 3U);
    if (doors_joined(furnished(offices(), seed, careless), 0.42) < 3U) ++narrow;
  }
  EXPECT_GT(narrow, 0U);
}

TEST(Furnish, NothingStandsOnTheRouteOfADrive) {
  FurnishOptions options;
  options.route = {{1.0, 1.0}, {4.0, 3.5}, {1.0, 3.5}};
  options.amount = 3.0;
  double nearest_m = 10.0;
  for (const FloorPlan& world : furnished_offices(options)) {
    std::vector<Polygon> bodies = outlines_of(world.furniture);
    for (const Polygon& leaf : open_leaves(world)) bodies.push_back(leaf);
    for (double share = 0.0; share <= 1.0; share += 0.01) {
      for (std::size_t leg = 1; leg < options.route.size(); ++leg) {
        const Point2 at = (1.0 - share) * options.route[leg - 1] + share * options.route[leg];
        for (const Polygon& body : bodies) {
          nearest_m = std::min(nearest_m, contains(body, at) ? 0.0 : distance_to(body, at));
        }
      }
    }
  }
  EXPECT_GE(nearest_m, options.route_clearance_m - 1e-9);
  EXPECT_LT(nearest_m, 1.0);  // or the test would see nothing
}

TEST(Furnish, WhatIsInTheWorldAlreadyStays) {
  FloorPlan world = offices();
  world.furniture = {{{box(1, 1, 2, 2), {}}, FurnitureKind::free_standing}};
  world.doors[0].leaf = Segment2{{5.02, 1.63}, {4.2, 1.63}};
  const FloorPlan result = furnished(world, 3, {});
  ASSERT_GT(result.furniture.size(), 1U);
  EXPECT_EQ(result.furniture[0].outline.outer, world.furniture[0].outline.outer);
  EXPECT_EQ(result.doors[0].leaf->b, world.doors[0].leaf->b);
}

TEST(Furnish, AWorldWithoutRoomsIsRefused) {
  EXPECT_THROW((void)furnished(square_room(), 1, {}), InputError);
  FurnishOptions options;
  options.amount = -1.0;
  EXPECT_THROW((void)furnished(offices(), 1, options), UsageError);
}

}  // namespace
}  // namespace roomatlas::testing_simulate
