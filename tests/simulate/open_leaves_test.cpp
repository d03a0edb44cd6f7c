// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/simulate/world.hpp"

#include <gtest/gtest.h>

#include "roomatlas/core/issue.hpp"
#include "simulate/simulated.hpp"

namespace roomatlas::testing_simulate {
namespace {

/// A square room with a leaf that stands in it, from (2, 3) to (3, 3).
FloorPlan room_with_a_leaf() {
  FloorPlan world = square_room();
  PlanDoor door;
  door.id = 1;
  door.jambs = {{2, 4}, {3, 4}};
  door.width_m = 1.0;
  door.leaf = Segment2{{2, 3}, {3, 3}};
  world.doors = {door};
  return world;
}

TEST(OpenLeaves, ALeafIsFourCentimetresThick) {
  const std::vector<Polygon> leaves = open_leaves(room_with_a_leaf());
  ASSERT_EQ(leaves.size(), 1U);
  const Box2 box = bounds(leaves[0].outer);
  EXPECT_NEAR(box.min.x(), 2.0, 1e-9);
  EXPECT_NEAR(box.max.x(), 3.0, 1e-9);
  EXPECT_NEAR(box.min.y(), 2.98, 1e-9);
  EXPECT_NEAR(box.max.y(), 3.02, 1e-9);
  EXPECT_NEAR(area(leaves[0]), 0.04, 1e-9);
}

TEST(OpenLeaves, ALeafOfNoLengthAndADoorWithoutOneAreNothing) {
  FloorPlan world = room_with_a_leaf();
  world.doors[0].leaf = Segment2{{2, 3}, {2, 3}};
  EXPECT_TRUE(open_leaves(world).empty());
  world.doors[0].leaf.reset();
  EXPECT_TRUE(open_leaves(world).empty());
}

TEST(OpenLeaves, RaysEndAtALeaf) {
  SimulationOptions options = exact();
  options.sensor = SensorKind::laser;
  options.laser = {0.0, 0.0};
  const Drive drive = {{2.5, 1.0}, {2.5, 1.5}};  // towards the leaf; the laser is 0.1 m ahead
  const auto with = run(room_with_a_leaf(), drive, options);
  const auto without = run(square_room(), drive, options);
  EXPECT_NEAR(with.back().reading.ranges_m[90], 2.98 - 1.6, 1e-5);
  EXPECT_NEAR(without.back().reading.ranges_m[90], 4.0 - 1.6, 1e-5);
}

TEST(OpenLeaves, ADriveThroughALeafIsRefused) {
  const Drive drive = {{2.5, 1.0}, {2.5, 3.7}};
  try {
    (void)run(room_with_a_leaf(), drive, exact());
    FAIL() << "the drive passes through the leaf";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("an open door leaf"), std::string::npos)
        << error.what();
  }
}

TEST(OpenLeaves, ARobotDoesNotStandInALeaf) {
  EXPECT_THROW(require_free(room_with_a_leaf(), {2.5, 3.1}, 0.2), InputError);
  EXPECT_NO_THROW(require_free(room_with_a_leaf(), {2.5, 2.7}, 0.2));
}

}  // namespace
}  // namespace roomatlas::testing_simulate
