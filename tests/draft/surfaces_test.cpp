// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "../../src/draft/sonar_jambs.hpp"
#include "roomatlas/draft/evidence.hpp"

namespace roomatlas {
namespace {

/// A sweep of a laser that stands in the origin of a room of 6 m x 4 m, by the nearest wall.
RangeReading sweep_in_a_room() {
  auto sensor = std::make_shared<RangeSensor>();
  sensor->max_range_m = 50.0;
  RangeReading reading;
  for (int deg = -90; deg <= 90; ++deg) {
    const double rad = deg * kPi / 180.0;
    sensor->robot_from_beam.push_back({0.0, 0.0, rad});
    const double x_m = std::abs(std::cos(rad)) > 1e-9 ? 3.0 / std::abs(std::cos(rad)) : 1e9;
    const double y_m = std::abs(std::sin(rad)) > 1e-9 ? 2.0 / std::abs(std::sin(rad)) : 1e9;
    reading.ranges_m.push_back(static_cast<float>(std::min(x_m, y_m)));
  }
  reading.sensor = sensor;
  return reading;
}

TEST(Surfaces, LookIntoTheRoomFromItsWalls) {
  const Pose2 pose{1.0, -2.0, 0.4};
  const std::vector<SurfacePoint> surfaces = surfaces_of(sweep_in_a_room(), pose, 10.0);
  EXPECT_GT(surfaces.size(), 120U);
  for (const SurfacePoint& surface : surfaces) {
    const Point2 at = inverse(pose) * surface.at;
    const double turn_rad = wrap_angle(surface.normal_rad - pose.theta_rad);
    const double corner_m = (Point2(3.0, at.y() > 0.0 ? 2.0 : -2.0) - at).norm();
    if (corner_m < 0.4) continue;  // corners are rounded off
    const bool is_ahead = std::abs(at.x() - 3.0) < 1e-4;
    const double expected_rad = is_ahead ? kPi : at.y() > 0.0 ? -kPi / 2.0 : kPi / 2.0;
    EXPECT_NEAR(wrap_angle(turn_rad - expected_rad), 0.0, 0.01) << at.transpose();
  }
}

TEST(Surfaces, ThinnedKeepTheirWeightAndMean) {
  std::vector<SurfacePoint> points;
  for (int i = 0; i < 50; ++i) points.push_back({{1.0 + 1e-4 * i, 2.0}, 0.3, 1.0});
  points.push_back({{1.0, 2.0}, 2.0, 1.0});  // looks another way
  const std::vector<SurfacePoint> thin = thinned(points);
  ASSERT_EQ(thin.size(), 2U);
  EXPECT_EQ(thin[0].weight + thin[1].weight, 51.0);
  const SurfacePoint& many = thin[0].weight > 1.0 ? thin[0] : thin[1];
  EXPECT_NEAR(many.at.x(), 1.00245, 1e-9);
  EXPECT_NEAR(many.normal_rad, 0.3, 1e-9);
}

/// What a sonar at `from` hears of a wall along y = 0 with a gap: the nearest point in its cone by
/// trying many, or nothing.
double heard_m(const Pose2& from, const Interval& gap, double half_cone_rad) {
  double nearest_m = 10.0;
  for (double x_m = -6.0; x_m <= 6.0; x_m += 0.002) {
    if (x_m > gap.low_m && x_m < gap.high_m) continue;
    const Point2 off = Point2(x_m, 0.0) - from.position();
    const double turn_rad = wrap_angle(std::atan2(off.y(), off.x()) - from.theta_rad);
    if (std::abs(turn_rad) <= half_cone_rad) nearest_m = std::min(nearest_m, off.norm());
  }
  return nearest_m;
}

TEST(SonarJambs, StandWhereTheEchoesBesideADoorSay) {
  // The face looks up; its along() is then -x.
  WallFace face;
  face.normal_rad = kPi / 2.0;
  face.seen = {{-6.0, 6.0}};
  BuildingEvidence evidence;
  evidence.kind = SensorKind::sonar;
  evidence.sonar_half_cone_rad = 15.0 * kPi / 180.0;
  const Interval door{0.4, 1.3};
  for (double x_m = -1.5; x_m <= 3.0; x_m += 0.1) {
    for (const double turn_deg : {-110.0, -90.0, -70.0}) {
      const Pose2 from{x_m, 1.2, turn_deg * kPi / 180.0};
      const double range_m = heard_m(from, door, evidence.sonar_half_cone_rad);
      evidence.echoes.push_back(
          {from, std::min(range_m, 5.0), range_m < 5.0, std::min(range_m, 5.0)});
    }
  }
  const auto jambs = sonar_jambs(face, -0.9, evidence);
  ASSERT_TRUE(jambs.has_value());
  EXPECT_NEAR(jambs->low_m, -1.3, 0.04);
  EXPECT_NEAR(jambs->high_m, -0.4, 0.04);
}

TEST(SonarJambs, AreUnknownWithoutEchoes) {
  WallFace face;
  face.seen = {{-6.0, 6.0}};
  EXPECT_FALSE(sonar_jambs(face, 0.0, BuildingEvidence{}).has_value());
}

}  // namespace
}  // namespace roomatlas
