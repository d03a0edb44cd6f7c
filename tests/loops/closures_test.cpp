// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/loops/closures.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support/drawn_world.hpp"

namespace roomatlas {
namespace {

/// An ASR of a drive through a room of 6 m x 3 m, every reading at its true pose.
Asr driven_asr() {
  const std::vector<Segment2> walls = {
      {{0, 0}, {6, 0}}, {{6, 0}, {6, 3}}, {{6, 3}, {0, 3}}, {{0, 3}, {0, 0}}};
  Asr asr;
  asr.id = 3;
  asr.readings = test::readings_along(walls, {{1.0, 1.5}, {5.0, 1.5}});
  for (const RangeReading& reading : asr.readings) {
    asr.path.push_back({reading.timestamp_s, reading.odom_from_robot, reading.odom_from_robot});
  }
  return asr;
}

TEST(ShapeOf, HasTheWallsThatTheReadingsSawAsPoints) {
  const AsrShape shape = shape_of(driven_asr(), {}, {});
  EXPECT_EQ(shape.id, 3);
  EXPECT_GT(shape.points.size(), 150U);  // 18 m of wall in cells of 10 cm
  for (const ScanPoint& point : shape.points) {
    const Point2& p = point.position;
    const double off_m = std::min({p.x(), 6.0 - p.x(), p.y(), 3.0 - p.y()});
    EXPECT_LT(std::abs(off_m), 0.05);
    EXPECT_TRUE(point.is_hit);
    EXPECT_TRUE(point.normal == Point2::Zero() ||
                point.normal.dot(Point2(3.0, 1.5) - point.position) > 0.0);
  }
}

TEST(ShapeOf, ItsPathIsThinnedAndKeepsItsReach) {
  const AsrShape shape = shape_of(driven_asr(), {}, {});
  EXPECT_LT(shape.path.size(), 12U);
  EXPECT_NEAR(shape.path.front().x(), 1.0, 1e-9);
  EXPECT_GT(shape.path.back().x(), 4.5);
}

TEST(ShapeOf, LeavesSonarsOut) {
  Asr asr = driven_asr();
  auto ring = std::make_shared<RangeSensor>(*asr.readings[0].sensor);
  ring->kind = SensorKind::sonar;
  for (RangeReading& reading : asr.readings) reading.sensor = ring;
  const AsrShape shape = shape_of(asr, {}, {});
  EXPECT_TRUE(shape.map.empty());
  EXPECT_TRUE(shape.points.empty());
}

TEST(PathDistance, IsThatOfTheNearestTwoPlaces) {
  AsrShape first;
  AsrShape second;
  first.path = {{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}};
  second.path = {{0.0, 0.0}, {5.0, 0.0}};
  // turned by 90 degrees at (4, 1): its places are (4, 1) and (4, 6)
  EXPECT_NEAR(path_distance_m(first, second, {4.0, 1.0, kPi / 2.0}), std::sqrt(5.0), 1e-12);
  second.path.clear();
  EXPECT_EQ(path_distance_m(first, second, {}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace roomatlas
