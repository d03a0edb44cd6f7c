// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "line_sums.hpp"
#include "roomatlas/draft/evidence.hpp"

namespace roomatlas {
namespace {

constexpr std::array kNeighbors = {2, 3, 5, 8, 12};  // beams to each side that are tried
constexpr double kLongestPiece_m = 0.8;              // longer pieces round the corners off
constexpr double kShortestPiece_m = 0.08;            // on shorter ones noise decides the normal
constexpr double kEnough_m = 0.35;                   // a span this long needs no more beams
constexpr double kStraight_m = 0.025;                // largest root mean square off the line
// Two neighbouring hits lie on one surface when they are nearer than this ...
constexpr double kGap_m = 0.06;
constexpr double kFlatness = 6.0;      // ... plus this many times the beams' distance there ...
constexpr double kLargestGap_m = 0.5;  // ... and never farther apart than this
constexpr double kSamePlace_m = 1e-6;  // beams that start nearer to each other are one laser's
constexpr double kVoxel_m = 0.02;      // walls are known to a centimetre or two
constexpr int kSectors = 36;           // of normals, 10 degrees each

/// Sums over the first beams of a sweep, so that those of any stretch are differences.
struct Sums {
  LineSums hits;
  int breaks = 0;  ///< between beams that are not on one surface
};

struct Hit {
  Point2 at = Point2::Zero();
  double range_m = 0.0;
  bool is_hit = false;
};

std::vector<Hit> hits_of(const RangeReading& reading, const Pose2& building_from_robot,
                         double max_range_m) {
  const RangeSensor& sensor = *reading.sensor;
  const PointTransform place(building_from_robot);
  std::vector<Hit> hits(reading.ranges_m.size());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const double range_m = reading.ranges_m[i];
    const bool is_hit = std::isfinite(range_m) && range_m > 0.0 && range_m < sensor.max_range_m &&
                        range_m <= max_range_m;
    if (!is_hit) continue;
    hits[i] = {place * (sensor.robot_from_beam[i] * Point2(range_m, 0.0)), range_m, true};
  }
  return hits;
}

bool is_break(const Hit& a, const Hit& b, double step_rad) {
  if (!a.is_hit || !b.is_hit) return true;
  const double gap_m = kGap_m + kFlatness * step_rad * std::min(a.range_m, b.range_m);
  return (a.at - b.at).norm() > std::min(gap_m, kLargestGap_m);
}

/// @param origin near the hits, so that squares stay small
std::vector<Sums> sums_of(const std::vector<Hit>& hits, const RangeSensor& sensor,
                          const Point2& origin) {
  std::vector<Sums> sums(hits.size() + 1);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    Sums& next = sums[i + 1] = sums[i];
    if (i > 0) {
      const Pose2& before = sensor.robot_from_beam[i - 1];
      const Pose2& beam = sensor.robot_from_beam[i];
      const double step_rad = std::abs(wrap_angle(beam.theta_rad - before.theta_rad));
      const bool is_another_laser = (beam.position() - before.position()).norm() > kSamePlace_m;
      if (is_another_laser || is_break(hits[i - 1], hits[i], step_rad)) ++next.breaks;
    }
    if (hits[i].is_hit) next.hits.add(hits[i].at - origin);
  }
  return sums;
}

/// The normal of beams `first` to `last`, modulo 180 degrees; nothing where they are not straight.
std::optional<double> normal_of(const std::vector<Sums>& sums, std::size_t first,
                                std::size_t last) {
  const FittedLine line = (sums[last + 1].hits - sums[first].hits).line();
  if (line.rms_m > kStraight_m) return std::nullopt;
  return line.direction_rad + kPi / 2.0;
}

/// The normal at a beam, from the longest stretch about it that is allowed.
std::optional<double> normal_at(std::size_t beam, const std::vector<Hit>& hits,
                                const std::vector<Sums>& sums) {
  std::optional<double> normal_rad;
  double span_m = 0.0;
  for (const int neighbors : kNeighbors) {
    const auto reach = static_cast<std::size_t>(neighbors);
    if (span_m >= kEnough_m || beam < reach || beam + reach >= hits.size()) break;
    const std::size_t first = beam - reach;
    const std::size_t last = beam + reach;
    if (sums[last + 1].breaks != sums[first + 1].breaks) break;
    const double longer_m = (hits[last].at - hits[first].at).norm();
    if (longer_m >= kLongestPiece_m) break;
    if (const auto better = normal_of(sums, first, last); better && longer_m > span_m) {
      normal_rad = better;
      span_m = longer_m;
    }
  }
  return span_m > kShortestPiece_m ? normal_rad : std::nullopt;
}

/// Points of one voxel and sector.
using Key = std::array<std::int64_t, 3>;  // x, y, sector

Key key_of(const SurfacePoint& point) {
  const double sector = point.normal_rad / (2.0 * kPi) * kSectors;
  const auto turned = static_cast<std::int64_t>(std::lround(sector));
  return {std::llround(point.at.x() / kVoxel_m), std::llround(point.at.y() / kVoxel_m),
          (turned % kSectors + kSectors) % kSectors};
}

}  // namespace

std::vector<SurfacePoint> surfaces_of(const RangeReading& reading, const Pose2& building_from_robot,
                                      double max_range_m) {
  std::vector<SurfacePoint> points;
  const RangeSensor& sensor = *reading.sensor;
  const std::vector<Hit> hits = hits_of(reading, building_from_robot, max_range_m);
  const std::vector<Sums> sums = sums_of(hits, sensor, building_from_robot.position());
  const PointTransform place(building_from_robot);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (!hits[i].is_hit) continue;
    const auto normal_rad = normal_at(i, hits, sums);
    if (!normal_rad) continue;
    const Point2 from = place * sensor.robot_from_beam[i].position();
    const bool is_away = direction(*normal_rad).dot(from - hits[i].at) < 0.0;
    points.push_back({hits[i].at, wrap_angle(*normal_rad + (is_away ? kPi : 0.0)), 1.0});
  }
  return points;
}

std::vector<SurfacePoint> thinned(std::vector<SurfacePoint> points) {
  std::vector<std::pair<Key, std::size_t>> order;
  order.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) order.emplace_back(key_of(points[i]), i);
  std::sort(order.begin(), order.end());
  std::vector<SurfacePoint> kept;
  for (std::size_t i = 0; i < order.size();) {
    Point2 sum = Point2::Zero();
    Point2 normal = Point2::Zero();
    double weight = 0.0;
    const Key key = order[i].first;
    for (; i < order.size() && order[i].first == key; ++i) {
      const SurfacePoint& point = points[order[i].second];
      sum += point.weight * point.at;
      normal += point.weight * direction(point.normal_rad);
      weight += point.weight;
    }
    kept.push_back({sum / weight, std::atan2(normal.y(), normal.x()), weight});
  }
  kept.shrink_to_fit();
  return kept;
}

}  // namespace roomatlas
