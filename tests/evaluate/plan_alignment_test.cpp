// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "evaluate/four_rooms.hpp"
#include "roomatlas/evaluate/plan_alignment.hpp"

namespace roomatlas {
namespace {

using namespace test;

void expect_near(const Pose2& found, const Pose2& wanted, double metres, double degrees_) {
  const Pose2 error = inverse(wanted) * found;
  EXPECT_LT(error.position().norm(), metres);
  EXPECT_LT(std::abs(degrees(error.theta_rad)), degrees_);
}

TEST(AlignPlan, FindsAnyMotionFromTheRoomsAlone) {
  for (const Pose2& truth_from_building :
       {Pose2{}, Pose2{30, -12, radians(77)}, Pose2{-5, 3, radians(-170)},
        Pose2{0.4, 0.2, radians(3)}}) {
    const FloorPlan plan = moved(inverse(truth_from_building), four_rooms());
    const PlanAlignment found = align_plan(plan, four_rooms(), {});
    EXPECT_EQ(found.by, AlignedBy::room_centroids);
    EXPECT_EQ(found.rooms, 4);
    EXPECT_GT(found.overlap, 0.95);
    expect_near(found.truth_from_building, truth_from_building, 0.1, 1.0);
  }
}

TEST(AlignPlan, FindsThePlaceOfAPlanThatShowsAPartOfTheBuilding) {
  const Pose2 truth_from_building{30, -12, radians(77)};
  FloorPlan part = four_rooms();
  part.rooms.erase(part.rooms.begin());
  part.rooms.erase(part.rooms.begin());  // room 3 and the corridor are left
  const PlanAlignment found =
      align_plan(moved(inverse(truth_from_building), part), four_rooms(), {});
  EXPECT_EQ(found.rooms, 2);
  expect_near(found.truth_from_building, truth_from_building, 0.1, 1.0);
}

TEST(AlignPlan, OfAnEmptyPlanIsNothing) {
  EXPECT_EQ(align_plan({}, four_rooms(), {}).by, AlignedBy::nothing);
  EXPECT_EQ(align_plan(four_rooms(), {}, {}).by, AlignedBy::nothing);
}

}  // namespace
}  // namespace roomatlas
