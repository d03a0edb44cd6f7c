// SPDX-License-Identifier: GPL-3.0-or-later
// What a drawn building says to rays, against where they meet its walls.
#include "roomatlas/locate/place_evidence.hpp"

#include <gtest/gtest.h>

#include <random>

#include "support/drawn_shape.hpp"

namespace roomatlas {
namespace {

using namespace test;

constexpr double kReachM = 12.0;
constexpr double kHalfConeRad = radians(12.0);

struct Drawn {
  std::vector<DrawnWall> walls = room_walls(0.0, 0.0, 5.0, 4.0, 1.0);
  Point2 middle{3.0, 2.6};
  SeenBuilding seen;
  Drawn() : Drawn(std::vector<DrawnWall>()) {}
  /// @param more walls that stand in the room besides
  explicit Drawn(const std::vector<DrawnWall>& more) {
    walls.insert(walls.end(), more.begin(), more.end());
    const AsrShape shape =
        seen_shape(1, walls, {middle, {3.6, 2.2}, {2.2, 3.0}, {1.4, 1.6}, {4.0, 1.0}}, {});
    const AsrShape* one = &shape;
    seen.add(sketch_of({&one, 1}, {{1, Pose2{}}}));
  }
};

Pose2 beam_at(const Point2& from, double heading_rad) { return {from.x(), from.y(), heading_rad}; }

/// Rays as a laser measures them, and as sonars do: the nearest wall of those that look at it.
std::vector<QueryRay> measured(const Drawn& drawn, const Point2& from, bool by_sonars) {
  std::vector<QueryRay> rays;
  for (int n = 0; n < 90; ++n) {
    const double heading_rad = radians(4.0 * n - 180.0);
    QueryRay ray{beam_at(from, heading_rad), kReachM, by_sonars ? kHalfConeRad : 0.0, false};
    for (int i = by_sonars ? -4 : 0; i <= (by_sonars ? 4 : 0); ++i) {
      const Point2 along = direction(heading_rad + i * kHalfConeRad / 4.0);
      const std::optional<double> range_m = range_to(drawn.walls, from, along);
      const bool is_square = std::max(std::abs(along.x()), std::abs(along.y())) > 0.8;
      if (!range_m || *range_m >= ray.range_m || (by_sonars && !is_square)) continue;
      ray.range_m = *range_m;
      ray.is_echo = true;
    }
    rays.push_back(ray);
  }
  return rays;
}

std::map<Told, int> told(const Drawn& drawn, const std::vector<QueryRay>& rays,
                         const Pose2& place) {
  AskedVisit visit;
  visit.rays = rays;
  PlaceEvidence evidence;
  add_evidence(visit, drawn.seen, place, {}, evidence);
  std::map<Told, int> counts;
  for (const Told one : evidence.rays) ++counts[one];
  return counts;
}

TEST(SeenBuilding, StopsRaysWhereTheyMeetItsWalls) {
  const Drawn drawn;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> turn(-kPi, kPi);
  int off = 0;
  for (int n = 0; n < 300; ++n) {
    const double heading_rad = turn(random);
    const SeenBuilding::Met met = drawn.seen.cast(beam_at(drawn.middle, heading_rad), kReachM);
    const double range_m = range_to(drawn.walls, drawn.middle, direction(heading_rad)).value();
    off += met.is_wall && std::abs(met.range_m - range_m) < 0.06 ? 0 : 1;
  }
  EXPECT_LE(off, 9);  // at the box's edges, where one cell has two walls
}

TEST(SeenBuilding, EndsARayWhereNothingIsKnown) {
  const Drawn drawn;
  const SeenBuilding::Met met = drawn.seen.cast(beam_at({-3.0, 2.0}, 0.0), kReachM);
  EXPECT_FALSE(met.is_wall);
  EXPECT_EQ(met.range_m, 0.0);
}

/// A screen of this width, 3.8 m from the left wall, around the height of 1.9 m.
DrawnWall screen(double width_m) {
  return {{3.8, 1.9 - width_m / 2.0}, {3.8, 1.9 + width_m / 2.0}};
}

TEST(SeenBuilding, TellsStretchesOfWallFromWhatStandsAbout) {
  const Pose2 beam = beam_at({2.0, 1.9}, 0.0);
  for (const double width_m : {0.5, 2.0}) {
    const Drawn drawn(std::vector{screen(width_m)});
    EXPECT_NEAR(drawn.seen.cast(beam, kReachM).range_m, 1.8, 0.05) << width_m;
    const SeenBuilding::Met stretch = drawn.seen.cast_to_stretch(beam, kReachM);
    EXPECT_TRUE(stretch.is_wall) << width_m;
    EXPECT_NEAR(stretch.range_m, width_m < 1.0 ? 3.0 : 1.8, 0.05) << width_m;
  }
}

TEST(SeenBuilding, FindsTheNearestWallThatLooksTheSameWay) {
  const Drawn drawn;
  const std::optional<double> off_m = drawn.seen.distance_to_wall({4.92, 2.0}, {-1.0, 0.0}, 0.15);
  ASSERT_TRUE(off_m.has_value());
  EXPECT_NEAR(*off_m, 0.08, 0.02);
  EXPECT_FALSE(drawn.seen.distance_to_wall({4.92, 2.0}, {1.0, 0.0}, 0.15));  // its other side
  EXPECT_FALSE(drawn.seen.distance_to_wall({4.7, 2.0}, {-1.0, 0.0}, 0.15));
}

TEST(PlaceEvidence, AgreesWithRaysWhereTheyWereMeasured) {
  const Drawn drawn;
  for (const bool by_sonars : {false, true}) {
    const std::vector<QueryRay> rays = measured(drawn, {2.6, 2.4}, by_sonars);
    std::map<Told, int> counts = told(drawn, rays, {});
    EXPECT_GT(counts[Told::agrees], by_sonars ? 55 : 80) << by_sonars;
    EXPECT_LE(counts[Told::contradicts], 2) << by_sonars;
  }
}

TEST(PlaceEvidence, ContradictsThemElsewhere) {
  const Drawn drawn;
  for (const bool by_sonars : {false, true}) {
    const std::vector<QueryRay> rays = measured(drawn, {2.6, 2.4}, by_sonars);
    for (const Pose2& place : {Pose2{0.8, 0.0, 0.0}, Pose2{-0.3, -0.7, 0.0}, Pose2{5.0, 4.8, kPi},
                               Pose2{5.0, 0.0, kPi / 2.0}}) {
      std::map<Told, int> counts = told(drawn, rays, place);
      EXPECT_GT(counts[Told::contradicts], 10) << by_sonars << " at " << place.x_m;
      EXPECT_LT(counts[Told::agrees], 60) << by_sonars << " at " << place.x_m;
    }
  }
}

TEST(PlaceEvidence, LetsRaysPassWhatStoodThereAndNoWall) {
  const std::vector<QueryRay> rays = measured(Drawn(), {2.6, 1.9}, false);
  std::map<Told, int> by_a_thing = told(Drawn(std::vector{screen(0.5)}), rays, {});
  std::map<Told, int> by_a_wall = told(Drawn(std::vector{screen(2.0)}), rays, {});
  EXPECT_LE(by_a_thing[Told::contradicts], 1);
  EXPECT_GE(by_a_thing[Told::nothing], 4);  // of 90: those that end behind it
  EXPECT_GE(by_a_wall[Told::contradicts], 14);
}

TEST(PlaceEvidence, SaysNothingWhereNobodyWas) {
  const Drawn drawn;
  for (const bool by_sonars : {false, true}) {
    std::map<Told, int> counts =
        told(drawn, measured(drawn, {2.6, 2.4}, by_sonars), {40.0, 0.0, 0.0});
    EXPECT_EQ(counts[Told::agrees] + counts[Told::contradicts], 0);
  }
}

TEST(QueryRays, AreSpreadOverThePathAndAroundTheRobot) {
  RangeSensor sensor;
  sensor.max_range_m = 8.0;
  for (int beam = 0; beam < 181; ++beam) {
    sensor.robot_from_beam.push_back({0.1, 0.0, radians(beam - 90.0)});
  }
  Asr asr;
  for (int n = 0; n < 21; ++n) {  // 2 m, 0.1 m a reading
    RangeReading reading;
    reading.sensor = std::make_shared<const RangeSensor>(sensor);
    reading.ranges_m.assign(181, 3.0F);
    reading.ranges_m[0] = std::numeric_limits<float>::quiet_NaN();
    reading.ranges_m[90] = 9.0F;
    asr.readings.push_back(reading);
    asr.path.push_back({static_cast<double>(n), {0.1 * n, 0.0, 0.0}, {}});
  }
  const std::vector<QueryRay> rays = rays_of(asr, {});
  EXPECT_EQ(rays.size(), 7U * 30U);  // every third reading, every sixth beam from the second on
  for (const QueryRay& ray : rays) {
    EXPECT_EQ(ray.is_echo, ray.range_m < 8.0);
    EXPECT_LE(ray.range_m, 8.0);
    EXPECT_EQ(ray.half_cone_rad, 0.0);
  }
}

}  // namespace
}  // namespace roomatlas
