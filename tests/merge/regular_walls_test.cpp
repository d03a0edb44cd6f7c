// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/merge/regular_walls.hpp"

#include "merge/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace roomatlas {
namespace {

using test::rectangle;

PlacedOutline room(RoomId id, Ring ring) { return {id, id, {std::move(ring), {}}}; }

/// The ring with a vertex each half metre, moved by up to `noise_m` along each axis.
Ring drawn(const Ring& corners, double noise_m, std::mt19937& random) {
  std::uniform_real_distribution<double> noise(-noise_m, noise_m);
  Ring ring;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2& from = corners[i];
    const Point2& to = corners[(i + 1) % corners.size()];
    const int steps = static_cast<int>(std::ceil((to - from).norm() / 0.5));
    for (int step = 0; step < steps; ++step) {
      ring.push_back(from + (to - from) * step / steps + Point2(noise(random), noise(random)));
    }
  }
  return ring;
}

std::vector<PlacedOutline> turned(std::vector<PlacedOutline> outlines, double angle_deg) {
  for (PlacedOutline& placed : outlines) {
    placed.outline = transformed(Pose2{0.0, 0.0, radians(angle_deg)}, placed.outline);
  }
  return outlines;
}

TEST(BuildingDirections, AreThoseOfMostWallsAndOfAWingAtAnAngle) {
  auto outlines = turned({room(1, rectangle(0, 0, 9, 3)), room(2, rectangle(0, 3, 9, 6))}, 17.0);
  const auto wing = turned({room(3, rectangle(20, 0, 24, 3))}, 60.0);
  outlines.insert(outlines.end(), wing.begin(), wing.end());
  const auto directions = building_directions(outlines, {});
  ASSERT_EQ(directions.size(), 2U);
  EXPECT_NEAR(degrees(directions[0]), 17.0, 1e-6);
  EXPECT_NEAR(degrees(directions[1]), 60.0, 1e-6);
  EXPECT_TRUE(building_directions({}, {}).empty());
}

TEST(RegularWalls, MakeARoughRoomARectangleWithClosedCorners) {
  std::mt19937 random(1);
  const auto outlines = turned({room(1, drawn(rectangle(0, 0, 5, 4), 0.02, random))}, 25.0);
  const RegularOutlines regular = with_regular_walls(outlines, {}, {});
  ASSERT_EQ(regular.outlines.size(), 1U);
  EXPECT_EQ(regular.kept, 0);
  EXPECT_EQ(regular.outlines[0].outline.outer.size(), 4U);
  EXPECT_NEAR(area(regular.outlines[0].outline), 20.0, 0.2);
}

TEST(RegularWalls, MeetInCornersThatSonarsDidNotHear) {
  // cut off at three corners, by a pillar at the last, with a long slanted wall beside it
  const Ring seen = {{0.4, 0},   {5, 0},     {5, 3.7}, {4.6, 4}, {1.4, 4},
                     {0.7, 3.2}, {0.7, 2.9}, {0, 2.9}, {0, 0.3}};
  RegularWallOptions options;
  const auto outlines = turned({room(1, seen)}, 30.0);
  const Ring as_seen = with_regular_walls(outlines, {}, options).outlines[0].outline.outer;
  EXPECT_EQ(as_seen.size(), seen.size());
  options.blind_corner_m = 0.8;
  const Polygon closed = with_regular_walls(outlines, {}, options).outlines[0].outline;
  const Ring expected = {{0, 0}, {5, 0}, {5, 4}, {1.4, 4}, {0.7, 3.2}, {0.7, 2.9}, {0, 2.9}};
  ASSERT_EQ(closed.outer.size(), expected.size());
  const Polygon truth = transformed(Pose2{0.0, 0.0, radians(30.0)}, Polygon{expected, {}});
  for (const Point2& corner : truth.outer) {
    EXPECT_TRUE(std::any_of(closed.outer.begin(), closed.outer.end(), [&](const Point2& found) {
      return (found - corner).norm() < 0.02;
    })) << corner.transpose();
  }
}

TEST(RegularWalls, OfNeighboursThatAreNearlyOnOneLineAreOnOneLine) {
  const RegularOutlines regular =
      with_regular_walls({room(1, rectangle(0, 0, 4, 3)), room(2, rectangle(4.2, 0.08, 8, 3.05)),
                          room(3, rectangle(8.2, 0.5, 12, 3))},
                         {}, {});
  const auto low = [&](std::size_t i) { return bounds(regular.outlines[i].outline.outer).min.y(); };
  EXPECT_NEAR(low(0), low(1), 1e-9);
  EXPECT_NEAR(low(0), 0.04, 0.02);
  EXPECT_NEAR(low(2), 0.5, 1e-9);  // half a metre off: another wall
}

TEST(RegularWalls, StayWithinTheStatedDistanceOfTheirEvidence) {
  std::mt19937 random(2);
  const RegularWallOptions options;
  for (int round = 0; round < 50; ++round) {
    std::vector<PlacedOutline> outlines;
    for (int i = 0; i < 4; ++i) {
      outlines.push_back(room(i + 1, drawn(rectangle(4.1 * i, 0, 4.1 * i + 4, 3), 0.06, random)));
    }
    const RegularOutlines regular = with_regular_walls(outlines, {}, options);
    for (std::size_t i = 0; i < outlines.size(); ++i) {
      for (const Point2& vertex : outlines[i].outline.outer) {
        EXPECT_LE(distance_to_boundary(regular.outlines[i].outline.outer, vertex),
                  1.5 * options.max_distance_m + 1e-9);
      }
    }
  }
}

TEST(RegularWalls, LeaveSlantedAndCurvedWallsAndTrueRoomsAsTheyAre) {
  Ring round;
  for (int i = 0; i < 24; ++i) round.push_back(Point2(20, 2) + 2.0 * direction(kPi * i / 12.0));
  const Ring slanted = {{0, 0}, {6, 0}, {4, 4}, {0, 4}};
  const Ring slightly_slanted = {{0, 10}, {6, 10}, {6, 14.6}, {0, 14}};
  const std::vector<PlacedOutline> outlines = {
      room(1, round), room(2, slanted), room(3, slightly_slanted),
      room(4, {{8, 0}, {12, 0}, {12, 2}, {10, 2}, {10, 4}, {8, 4}})};
  const RegularOutlines regular = with_regular_walls(outlines, {}, {});
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const Ring& before = outlines[i].outline.outer;
    EXPECT_NEAR(area(regular.outlines[i].outline), area(outlines[i].outline),
                0.001 * area(outlines[i].outline));
    ASSERT_EQ(regular.outlines[i].outline.outer.size(), before.size()) << i;
    for (std::size_t v = 0; v < before.size(); ++v) {
      EXPECT_LT(distance_to_boundary(regular.outlines[i].outline.outer, before[v]), 1e-6) << i;
    }
  }
}

}  // namespace
}  // namespace roomatlas
