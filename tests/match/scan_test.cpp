// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/match/scan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace roomatlas {
namespace {

/// A beam a degree from -90 to 90 degrees, ahead of the robot's middle.
RangeReading reading_of(const std::vector<float>& ranges_m, double max_range_m = 30.0) {
  auto sensor = std::make_shared<RangeSensor>();
  sensor->max_range_m = max_range_m;
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    sensor->robot_from_beam.push_back({0.2, 0.1, radians(static_cast<double>(i) - 90.0)});
  }
  return {0.0, {}, sensor, ranges_m};
}

/// Ranges to the line of points p with across . p == distance; 81 m where a beam misses it.
std::vector<float> ranges_to_wall(const Point2& across, double distance_m) {
  std::vector<float> ranges;
  for (int deg = -90; deg <= 90; ++deg) {
    const double closing = across.dot(direction(radians(deg)));
    const double range_m = (distance_m - across.dot(Point2(0.2, 0.1))) / closing;
    ranges.push_back(static_cast<float>(closing > 0.01 && range_m < 40.0 ? range_m : 81.0));
  }
  return ranges;
}

TEST(Scan, TheNormalsOfAWallArePerpendicularToItAndLookAtTheSensor) {
  for (const double angle_deg : {0.0, 35.0, -60.0, 90.0}) {
    const Point2 across = direction(radians(angle_deg));
    const Scan scan = scan_of(reading_of(ranges_to_wall(across, 2.0)), {});
    int with_normal = 0;
    for (const ScanPoint& point : scan.points) {
      const Point2 ray = point.position - scan.sensor;
      const bool is_steep = ray.normalized().dot(across) > std::cos(radians(55.0));
      if (is_steep) {
        EXPECT_NEAR(point.normal.norm(), 1.0, 1e-9) << angle_deg;
      }
      if (point.normal == Point2::Zero()) continue;
      ++with_normal;
      EXPECT_LT((point.normal + across).norm(), 1e-4) << angle_deg;
    }
    EXPECT_GT(with_normal, 50) << angle_deg;
  }
}

/// How many points of a noisy sweep from near a wall have a direction more than 20 degrees off it.
int normals_astray(const ScanOptions& options) {
  constexpr int kBeams = 401;
  std::mt19937 engine(5);
  std::normal_distribution<double> noise(0.0, 0.02);
  auto sensor = std::make_shared<RangeSensor>();
  sensor->max_range_m = 10.0;
  RangeReading reading;
  for (int i = 0; i < kBeams; ++i) {
    const double at_rad = radians(-40.0 + 80.0 * i / (kBeams - 1));
    sensor->robot_from_beam.push_back({0.0, 0.0, at_rad});
    reading.ranges_m.push_back(static_cast<float>(0.6 / std::cos(at_rad) + noise(engine)));
  }
  reading.sensor = sensor;
  int astray = 0;
  for (const ScanPoint& point : scan_of(reading, options).points) {
    const bool is_told = point.normal.squaredNorm() > 0.0;
    if (is_told && -point.normal.x() < std::cos(radians(20.0))) ++astray;
  }
  return astray;
}

TEST(Scan, FineBeamsOnANearWallTellItsDirectionInSpiteOfTheirNoise) {
  ScanOptions options;
  EXPECT_LT(normals_astray(options), 20);
  options.fine_rad = 0.0;
  EXPECT_GT(normals_astray(options), 200);
}

TEST(Scan, ANormalIsNotDrawnAcrossAGap) {
  std::vector<float> ranges = ranges_to_wall(Point2::UnitX(), 2.0);
  const std::vector<float> behind = ranges_to_wall(Point2::UnitX(), 3.0);
  std::copy(behind.begin() + 90, behind.end(), ranges.begin() + 90);
  for (const ScanPoint& point : scan_of(reading_of(ranges), {}).points) {
    if (point.normal == Point2::Zero()) continue;
    EXPECT_LT((point.normal + Point2::UnitX()).norm(), 1e-4);
  }
}

TEST(Scan, ScatteredPointsHaveNoNormal) {
  std::vector<float> ranges;
  for (int i = 0; i <= 180; ++i) ranges.push_back(i % 2 == 0 ? 2.0F : 2.15F);
  for (const ScanPoint& point : scan_of(reading_of(ranges), {}).points) {
    EXPECT_TRUE(point.is_hit);
    EXPECT_EQ(point.normal, Point2::Zero());
  }
}

TEST(Scan, FarReturnsAndTheSensorsLimitAreFreeSpaceAndNothingMore) {
  ScanOptions options;
  options.max_hit_m = 5.0;
  const std::vector<float> ranges = {1.0F, 5.0F, 5.1F, 7.0F, 8.0F, 9.0F};
  const Scan scan = scan_of(reading_of(ranges, 8.0), options);
  ASSERT_EQ(scan.points.size(), ranges.size());
  const double lengths[] = {1.0, 5.0, 5.0, 5.0, 5.0, 5.0};
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    EXPECT_NEAR((scan.points[i].position - scan.sensor).norm(), lengths[i], 1e-6);
    EXPECT_EQ(scan.points[i].is_hit, i < 2) << ranges[i];
    EXPECT_EQ(scan.points[i].normal, Point2::Zero());
  }
  options.max_hit_m = 20.0;  // now the sensor's own limit decides
  const Scan farther = scan_of(reading_of(ranges, 8.0), options);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    EXPECT_EQ(farther.points[i].is_hit, i < 4) << ranges[i];
    EXPECT_NEAR((farther.points[i].position - scan.sensor).norm(), ranges[i], 1e-6);
  }
}

TEST(Scan, LeavesOutWhatIsNoMeasurement) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const RangeReading reading =
      reading_of({nan, 2.0F, infinity, -infinity, 0.0F, -1.0F, 0.05F, 3.0F, 49.0F, 81.0F});
  const Scan scan = scan_of(reading, {});
  ASSERT_EQ(scan.points.size(), 2U);
  EXPECT_LT(
      (scan.points[0].position - reading.sensor->robot_from_beam[1] * Point2(2.0, 0.0)).norm(),
      1e-6);
  EXPECT_LT(
      (scan.points[1].position - reading.sensor->robot_from_beam[7] * Point2(3.0, 0.0)).norm(),
      1e-6);
}

TEST(Scan, OfASensorWithoutBeamsIsEmpty) {
  EXPECT_TRUE(scan_of(reading_of({}), {}).points.empty());
}

}  // namespace
}  // namespace roomatlas
