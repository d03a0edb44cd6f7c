// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/asr/doorway.hpp"

#include <gtest/gtest.h>

#include "support/drawn_world.hpp"

namespace roomatlas {
namespace {

using namespace test;

const WorldDrawing kTwoRooms = {"######################",  //
                                "#         #          #",  //
                                "#         #          #",  //
                                "#         #          #",  //
                                "#         #          #",  //
                                "#                    #",  //
                                "#    a          b    #",  //
                                "#                    #",  //
                                "#         #          #",  //
                                "#         #          #",  //
                                "#         #          #",  //
                                "#         #          #",  //
                                "######################"};
const Point2 kDoor(3.15, 1.95);  ///< mid-point of the gap in the drawing, which is 0.9 m wide
constexpr double kCellM = 0.1;

/// The grid after driving along `drives` through a drawn world that lies anywhere in the grid.
HimmGrid grid_after(const WorldDrawing& drawing, const std::vector<Polyline>& drives,
                    const Pose2& grid_from_world) {
  HimmGrid grid(kCellM);
  std::int64_t ignored = 0;
  LaserRobot robot;
  robot.odom_from_world = grid_from_world;
  for (const Polyline& drive : drives) {
    for (const RangeReading& reading : readings_along(surfaces_of(drawing), drive, robot)) {
      grid.add_sweep(rays_of(reading, reading.odom_from_robot, {}, ignored));
      grid.mark_robot(reading.odom_from_robot, {});
    }
  }
  return grid;
}

/// Doorways found along a drive that has been driven, asked for every 0.1 m.
std::vector<Doorway> doorways_along(const WorldDrawing& drawing, const Polyline& drive,
                                    const Pose2& grid_from_world = {0.03, 0.04, 0.0}) {
  const HimmGrid grid = grid_after(drawing, {drive}, grid_from_world);
  LaserRobot robot;
  robot.step_m = 0.1;
  std::vector<Doorway> doorways;
  for (const Pose2& pose : poses_along(drive, robot)) {
    const auto doorway = find_doorway(grid, grid_from_world * pose, {});
    if (doorway) doorways.push_back(*doorway);
  }
  return doorways;
}

double degrees_between(double a_rad, double b_rad) {
  return std::abs(degrees(wrap_angle(a_rad - b_rad)));
}

/// Asks for the door of kTwoRooms every 0.1 m of the way through its wall, as the recorder does,
/// and takes the narrowest.
void expect_door_of_two_rooms(const Polyline& drive, const Pose2& grid_from_world,
                              double travel_rad) {
  const HimmGrid grid = grid_after(kTwoRooms, {drive}, grid_from_world);
  std::optional<Doorway> doorway;
  for (double off_m = -0.1; off_m < 0.15; off_m += 0.1) {
    const Point2 at = kDoor + off_m * direction(travel_rad);
    const auto found = find_doorway(grid, grid_from_world * Pose2{at.x(), at.y(), travel_rad}, {});
    if (found && (!doorway || found->width_m < doorway->width_m)) doorway = found;
  }
  ASSERT_TRUE(doorway) << "turned by " << degrees(grid_from_world.theta_rad);
  EXPECT_LT((doorway->frame_from_pivot.position() - grid_from_world * kDoor).norm(), 2.0 * kCellM);
  EXPECT_NEAR(doorway->width_m, 0.9, 1.5 * kCellM);
  const double axis_rad = std::abs(wrap_angle(travel_rad)) < kPi / 2.0 ? 0.0 : kPi;
  EXPECT_LE(
      degrees_between(doorway->frame_from_pivot.theta_rad, grid_from_world.theta_rad + axis_rad),
      20.0);
  const Point2 left = inverse(doorway->frame_from_pivot) * doorway->jambs.a;
  const Point2 right = inverse(doorway->frame_from_pivot) * doorway->jambs.b;
  EXPECT_LT((left - Point2(0.0, doorway->width_m / 2.0)).norm(), 1e-9);
  EXPECT_LT((right + Point2(0.0, doorway->width_m / 2.0)).norm(), 1e-9);
}

TEST(FindDoorway, FindsADoorBetweenTwoRoomsWithItsMiddleWidthAndDirection) {
  const Polyline drive = way_points_of(kTwoRooms);
  expect_door_of_two_rooms(drive, {0.03, 0.04, 0.0}, 0.0);
}

TEST(FindDoorway, FindsTheSameDoorHoweverTheWorldLiesInTheGrid) {
  const Polyline drive = way_points_of(kTwoRooms);
  for (const double turn_deg : {30.0, 45.0, 90.0, 163.0, -70.0}) {
    expect_door_of_two_rooms(drive, {-7.21, 3.57, radians(turn_deg)}, 0.0);
  }
}

TEST(FindDoorway, SwapsTheJambsForARobotThatGoesTheOtherWay) {
  Polyline drive = way_points_of(kTwoRooms);
  std::reverse(drive.begin(), drive.end());
  expect_door_of_two_rooms(drive, {0.03, 0.04, 0.0}, -kPi);
}

TEST(FindDoorway, FindsTheDoorsOwnDirectionWhenThePathGoesThroughItAskew) {
  for (const double askew_deg : {-25.0, 25.0}) {
    const Point2 along = direction(radians(askew_deg));
    expect_door_of_two_rooms({kDoor - 1.5 * along, kDoor + 1.5 * along}, {0.03, 0.04, 0.0},
                             radians(askew_deg));
  }
}

TEST(FindDoorway, LeansToNeitherSide) {
  const Polyline drive = way_points_of(kTwoRooms);
  double sum_deg = 0.0;
  int count = 0;
  for (double turn_deg = 0.0; turn_deg < 90.0; turn_deg += 5.0) {
    const Pose2 grid_from_world{-7.21, 3.57, radians(turn_deg)};
    for (const Doorway& doorway : doorways_along(kTwoRooms, drive, grid_from_world)) {
      sum_deg +=
          degrees(wrap_angle(doorway.frame_from_pivot.theta_rad - grid_from_world.theta_rad));
      ++count;
    }
  }
  ASSERT_GE(count, 40);
  EXPECT_NEAR(sum_deg / count, 0.0, 3.0);
}

TEST(FindDoorway, FindsNothingInTheMiddleOfARoom) {
  const Polyline drive = way_points_of(kTwoRooms);
  for (const Doorway& doorway : doorways_along(kTwoRooms, drive)) {
    EXPECT_LT((doorway.frame_from_pivot.position() - kDoor).norm(), 0.5);
  }
}

TEST(FindDoorway, FindsNothingInACorridorOfConstantWidth) {
  for (const WorldDrawing& corridor : {WorldDrawing{"################################",  //
                                                    "                                ",  //
                                                    " a                            b ",  //
                                                    "                                ",  //
                                                    "################################"},
                                       WorldDrawing{"################################",  //
                                                    "                                ",  //
                                                    "                                ",  //
                                                    " a                            b ",  //
                                                    "                                ",  //
                                                    "                                ",  //
                                                    "################################"}}) {
    Polyline inside = way_points_of(corridor);
    inside = {inside[0] + Point2(1.5, 0.0), inside[1] - Point2(1.5, 0.0)};
    EXPECT_TRUE(doorways_along(corridor, inside).empty()) << corridor.size() - 2 << " letters";
  }
}

TEST(FindDoorway, FindsNothingInAWideGap) {
  const WorldDrawing wide = {"######################",  //
                             "#         #          #",  //
                             "#         #          #",  //
                             "#                    #",  //
                             "#                    #",  //
                             "#                    #",  //
                             "#    a          b    #",  //
                             "#                    #",  //
                             "#                    #",  //
                             "#         #          #",  //
                             "#         #          #",  //
                             "######################"};
  EXPECT_TRUE(doorways_along(wide, way_points_of(wide)).empty());
}

TEST(FindDoorway, FindsNothingInAGapThatIsTooNarrow) {
  WorldDrawing narrow = kTwoRooms;
  for (const std::size_t line : {5U, 7U}) narrow[line][10] = '#';
  const std::vector<Polyline> on_both_sides = {{{0.9, 1.95}, {2.4, 1.95}},
                                               {{5.4, 1.95}, {3.9, 1.95}}};
  const Pose2 grid_from_world{0.03, 0.04, 0.0};
  const HimmGrid grid = grid_after(narrow, on_both_sides, grid_from_world);
  const Pose2 in_the_gap{kDoor.x(), kDoor.y(), 0.0};
  EXPECT_FALSE(find_doorway(grid, grid_from_world * in_the_gap, {}));
  EXPECT_TRUE(find_doorway(grid_after(kTwoRooms, on_both_sides, grid_from_world),
                           grid_from_world * in_the_gap, {}))
      << "the same views do find a door of 0.9 m";
}

TEST(FindDoorway, FindsNothingInAGridThatHasSeenNothing) {
  EXPECT_FALSE(find_doorway(HimmGrid(kCellM), {}, {}));
}

}  // namespace
}  // namespace roomatlas
