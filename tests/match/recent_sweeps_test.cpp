// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/match/recent_sweeps.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace roomatlas {
namespace {

/// What few beams, 0.3 m apart there, see of a wall along y at x = 2 m, from y.
Scan sweep_from(double y_m) {
  Scan scan;
  for (int i = -3; i <= 3; ++i) scan.points.push_back({{2.0, 0.3 * i}, Point2::Zero(), true});
  for (ScanPoint& point : scan.points) point.position.y() += std::fmod(0.7 * y_m, 0.3);
  return scan;
}

TEST(RecentSweeps, AreNeededWhereBeamsAreFew) {
  RangeSensor sensor;
  sensor.robot_from_beam.resize(36);
  const RecentSweeps recent({});
  EXPECT_TRUE(recent.are_needed(sensor));
  sensor.robot_from_beam.resize(181);
  EXPECT_FALSE(recent.are_needed(sensor));
}

TEST(RecentSweeps, TellTogetherWhichWayAWallRuns) {
  const Pose2 turned{3.0, 1.0, 0.8};  // any frame will do
  RecentSweeps recent({});
  Scan first = sweep_from(0.0);
  recent.add_normals(first, turned);
  for (const ScanPoint& point : first.points) EXPECT_EQ(point.normal, Point2::Zero());
  for (int i = 0; i < 6; ++i) {
    recent.add(sweep_from(0.1 * i), turned * Pose2{0.0, 0.1 * i, 0.0});
  }
  Scan scan = sweep_from(0.6);
  recent.add_normals(scan, turned * Pose2{0.0, 0.6, 0.0});
  int told = 0;
  for (const ScanPoint& point : scan.points) {
    if (point.normal.squaredNorm() == 0.0) continue;
    ++told;
    EXPECT_LT((point.normal + Point2::UnitX()).norm(), 1e-6);
  }
  EXPECT_GE(told, 5);
}

TEST(RecentSweeps, AreForgottenWithTheirFrame) {
  RecentSweeps recent({});
  for (int i = 0; i < 6; ++i) recent.add(sweep_from(0.1 * i), {0.0, 0.1 * i, 0.0});
  recent.clear();
  Scan scan = sweep_from(0.6);
  recent.add_normals(scan, {0.0, 0.6, 0.0});
  for (const ScanPoint& point : scan.points) EXPECT_EQ(point.normal, Point2::Zero());
}

}  // namespace
}  // namespace roomatlas
