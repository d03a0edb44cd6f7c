// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/rooms/openings.hpp"

#include <gtest/gtest.h>

#include "rooms/sketched_building.hpp"

namespace roomatlas {
namespace {

using test::SketchedBuilding;

TEST(Openings, ADoorIsOneOpeningInTheMiddleOfItsWall) {
  SketchedBuilding building = test::two_rooms();
  building.drive({{1, 1}, {2, 2.4}, {6, 2.4}});
  const auto openings = find_openings(building.grid(), {});
  ASSERT_EQ(openings.size(), 1U);
  EXPECT_NEAR(openings[0].frame_from_pivot.position().x(), 4.1, 0.06);
  EXPECT_NEAR(openings[0].frame_from_pivot.position().y(), 2.45, 0.06);
  EXPECT_NEAR(openings[0].width_m, 0.9, 0.11);
  EXPECT_NEAR(std::abs(std::sin(openings[0].frame_from_pivot.theta_rad)), 0.0, 0.15)
      << "across the wall";
}

TEST(Openings, ADoorThatTheRobotSawButDidNotUseIsOne) {
  SketchedBuilding building = test::two_rooms();
  building.drive({{1, 1}, {3, 1}});
  EXPECT_EQ(find_openings(building.grid(), {}).size(), 1U);
}

TEST(Openings, JambsLieAtThePeaksOfTheEchoes) {
  SketchedBuilding building = test::two_rooms();
  building.drive({{1, 1}, {2, 2.4}, {6, 2.4}});
  ReflectionMap map = building.map();
  // A sonar hears the jambs early: fewer echoes lie up to 0.2 m inside the door.
  for (int i = 0; i < 8; ++i) {
    for (const double y : {2.05, 2.15, 2.75, 2.85}) map.add_sweep({{{{3.0, y}, {4.1, y}}, true}});
  }
  const auto early =
      find_openings(building_grid(map, SensorKind::sonar, building.path(), {}, {}), {});
  ASSERT_EQ(early.size(), 1U);
  EXPECT_LT(early[0].width_m, 0.75);
  const Doorway exact = with_jambs_at_peaks(early[0], map);
  EXPECT_NEAR(exact.width_m, 0.9, 0.21);
  EXPECT_GT(exact.width_m, early[0].width_m + 0.1);
  EXPECT_NEAR(exact.frame_from_pivot.position().y(), 2.45, 0.08);
}

TEST(Openings, TheGapBetweenATableAndAWallIsNone) {
  SketchedBuilding building(8.0, 5.0);
  building.box(3.5, 0.9, 4.5, 4.1);  // 0.9 m from both long walls
  building.drive({{1, 2.5}, {1, 0.45}, {7, 0.45}, {7, 4.55}, {1, 4.55}});
  EXPECT_TRUE(find_openings(building.grid(), {}).empty());
}

TEST(Openings, ANarrowCorridorWithOpenDoorsOnBothSidesIsNone) {
  SketchedBuilding building(12.0, 7.2);
  building.box(0.0, 0.0, 5.0, 3.0);  // the corridor is 1.2 m wide, rooms open to both sides
  building.box(6.0, 0.0, 12.0, 3.0);
  building.box(0.0, 4.2, 5.9, 7.2);
  building.box(6.9, 4.2, 12.0, 7.2);
  building.drive({{0.6, 3.6}, {11.4, 3.6}});
  for (const Doorway& opening : find_openings(building.grid(), {})) {
    EXPECT_GT(std::abs(std::sin(opening.frame_from_pivot.theta_rad)), 0.7)
        << "across the corridor at " << opening.frame_from_pivot.position().transpose();
  }
}

TEST(Openings, AWideOneNeedsAWiderLimit) {
  SketchedBuilding building(8.2, 5.0);
  building.box(4.0, 0.0, 4.2, 1.5);
  building.box(4.0, 3.5, 4.2, 5.0);
  building.drive({{1, 1}, {3, 3}});
  EXPECT_TRUE(find_openings(building.grid(), {}).empty());
  OpeningOptions windows;
  windows.max_width_m = 2.5;
  EXPECT_EQ(find_openings(building.grid(), windows).size(), 1U);
}

}  // namespace
}  // namespace roomatlas
