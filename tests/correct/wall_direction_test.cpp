// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/correct/wall_direction.hpp"
#include "roomatlas/core/pose2.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace roomatlas {
namespace {

const Polyline kRectangle = {{0, 0}, {6, 0}, {6, 4}, {0, 4}, {0, 0}};  // 20 m of wall

WallPolyline wall(const Polyline& vertices) {
  return {vertices, std::vector<bool>(vertices.size() - 1, true)};
}

WallPolyline turned(const Polyline& vertices, double angle_deg) {
  return wall(transformed({1.0, -2.0, wrap_angle(radians(angle_deg))}, vertices));
}

/// Distance between two directions modulo 90 degrees.
double apart_deg(double angle_rad, double expected_deg) {
  return std::abs(degrees(wrap_quarter(angle_rad - radians(expected_deg))));
}

Polyline round_room(int sides, double radius_m) {
  Polyline ring;
  for (int i = 0; i <= sides; ++i) ring.push_back(radius_m * direction(2.0 * kPi * i / sides));
  return ring;
}

TEST(WallDirection, OfARectangleTurnedByAnyAngleIsThatAngleModuloAQuarterTurn) {
  for (double angle_deg = -180.0; angle_deg < 180.0; angle_deg += 0.5) {
    const auto found = wall_direction({turned(kRectangle, angle_deg)}, {});
    ASSERT_TRUE(found.has_value()) << angle_deg;
    EXPECT_LT(apart_deg(found->angle_rad, angle_deg), 1e-6) << angle_deg;
    EXPECT_GE(found->angle_rad, 0.0) << angle_deg;
    EXPECT_LT(found->angle_rad, kPi / 2.0) << angle_deg;
    EXPECT_NEAR(found->aligned_share, 1.0, 1e-9) << angle_deg;
  }
}

TEST(WallDirection, DoesNotDependOnTheOrderOrTheSenseOfTheWalls) {
  const WallPolyline south = turned({{0, 0}, {6, 0}}, 20.0);
  const WallPolyline north = turned({{6, 4}, {0, 4}}, 23.0);
  const WallPolyline west = turned({{0, 4}, {0, 0}}, 21.0);
  WallPolyline west_backwards = west;
  std::swap(west_backwards.vertices_asr.front(), west_backwards.vertices_asr.back());
  const auto one = wall_direction({south, north, west}, {});
  const auto other = wall_direction({west_backwards, south, north}, {});
  ASSERT_TRUE(one && other);
  EXPECT_NEAR(one->angle_rad, other->angle_rad, 1e-12);
}

TEST(SettledDirection, IsThatOfMostWallBesideWingsAndCurves) {
  Asr hall;  // lies at 10 degrees, found at 13 in its own frame
  hall.walls = {turned(kRectangle, 13.0), wall(round_room(40, 4.0))};
  Asr wing;  // its walls lie at 14.5
  wing.walls = {turned({{0, 0}, {9, 0}}, -5.5)};
  const double found =
      settled_direction(radians(12.0), {&hall, &wing}, {radians(-3.0), radians(20.0)}, {});
  EXPECT_LT(apart_deg(found, 10.0), 0.1);
  const auto by_mean = wall_direction(
      {turned(kRectangle, 10.0), turned(round_room(40, 4.0), -3.0), turned({{0, 0}, {9, 0}}, 14.5)},
      {});
  ASSERT_TRUE(by_mean);
  EXPECT_GT(apart_deg(by_mean->angle_rad, 10.0), 0.5);
}

TEST(WallDirection, WeighsWallsByTheirLength) {
  // 9 m at 10 degrees and 3 m at 14: (9 * 10 + 3 * 14) / 12 = 11
  const auto found =
      wall_direction({turned({{0, 0}, {9, 0}}, 10.0), turned({{0, 0}, {0, 3}}, 14.0)}, {});
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(degrees(found->angle_rad), 11.0, 1e-6);
}

TEST(WallDirection, IsNotKnownFromTooLittleWall) {
  WallDirectionOptions options;
  options.min_total_m = 3.0;
  options.min_edge_m = 0.4;
  EXPECT_FALSE(wall_direction({}, options).has_value());
  EXPECT_FALSE(wall_direction({wall({{1, 1}})}, options).has_value());
  EXPECT_FALSE(wall_direction({wall({{0, 0}, {2.9, 0}})}, options).has_value());
  EXPECT_TRUE(wall_direction({wall({{0, 0}, {3.1, 0}})}, options).has_value());
  const WallPolyline crumb = wall({{0, 0}, {0.39, 0}});
  EXPECT_FALSE(wall_direction(std::vector<WallPolyline>(20, crumb), options).has_value());
}

TEST(WallDirection, IsNotKnownInARoundRoomOrATriangle) {
  EXPECT_FALSE(wall_direction({wall(round_room(24, 3.0))}, {}).has_value());
  EXPECT_FALSE(wall_direction({wall(round_room(36, 4.0))}, {}).has_value());
  EXPECT_FALSE(wall_direction({wall(round_room(3, 5.0))}, {}).has_value());
}

TEST(WallDirection, SharesOneDirectionBetweenAWallAndItsPerpendicular) {
  const auto corner = wall_direction({turned({{0, 0}, {5, 0}, {5, 2}, {7, 2}}, 33.0)}, {});
  ASSERT_TRUE(corner.has_value());
  EXPECT_LT(apart_deg(corner->angle_rad, 33.0), 1e-6);
}

TEST(WallDirection, HoldsAgainstFurnitureAtAnyAngle) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> angle_deg(0.0, 360.0);
  std::uniform_real_distribution<double> length_m(0.3, 1.2);
  for (int trial = 0; trial < 100; ++trial) {
    const double room_deg = angle_deg(random);
    std::vector<WallPolyline> walls = {turned(kRectangle, room_deg)};
    for (int i = 0; i < 10; ++i) {
      walls.push_back(turned({{0, 0}, {length_m(random), 0}}, angle_deg(random)));
    }
    const auto found = wall_direction(walls, {});
    ASSERT_TRUE(found.has_value()) << room_deg;
    EXPECT_LT(apart_deg(found->angle_rad, room_deg), 2.0);
    EXPECT_LT(found->aligned_share, 1.0);
    EXPECT_GT(found->aligned_share, 0.5);
  }
}

TEST(WrapQuarter, LeavesWhatIsLeftModuloAQuarterTurn) {
  EXPECT_NEAR(degrees(wrap_quarter(radians(100.0))), 10.0, 1e-9);
  EXPECT_NEAR(degrees(wrap_quarter(radians(-100.0))), -10.0, 1e-9);
  EXPECT_NEAR(degrees(wrap_quarter(radians(44.0))), 44.0, 1e-9);
  EXPECT_NEAR(degrees(wrap_quarter(radians(46.0))), -44.0, 1e-9);
  EXPECT_EQ(wrap_quarter(kPi / 4.0), -kPi / 4.0);
  EXPECT_EQ(wrap_quarter(-kPi / 4.0), -kPi / 4.0);
}

TEST(WrapQuarter, StaysInItsHalfOpenIntervalAndTakesWholeQuartersAway) {
  for (double angle = -20.0; angle < 20.0; angle += 0.013) {
    const double left = wrap_quarter(angle);
    EXPECT_GE(left, -kPi / 4.0);
    EXPECT_LT(left, kPi / 4.0);
    const double quarters = (angle - left) / (kPi / 2.0);
    EXPECT_NEAR(quarters, std::round(quarters), 1e-9);
  }
}

}  // namespace
}  // namespace roomatlas
