// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/match/scan.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr std::size_t kMinPoints = 4;   // fewer beams tell no direction
constexpr double kMaxFlatness = 0.15;   // spread across the line over spread along it
constexpr double kStraightM = 0.03;     // a line this straight ...
constexpr double kRoughFlatness = 0.1;  // ... may be less elongated than one that is not

/// The beams beside `at` that lie on the same surface: each near the one before.
struct Span {
  std::size_t first = 0;
  std::size_t last = 0;  // included
};
Span surface_around(const std::vector<ScanPoint>& points, std::size_t at,
                    const ScanOptions& options) {
  const auto joined = [&](std::size_t a, std::size_t b) {
    return points[a].is_hit && points[b].is_hit &&
           (points[a].position - points[b].position).norm() < options.normal_gap_m;
  };
  const auto reach = static_cast<std::size_t>(options.normal_neighbors);
  Span span{at, at};
  while (span.first > 0 && at - span.first < reach && joined(span.first - 1, span.first)) {
    --span.first;
  }
  while (span.last + 1 < points.size() && span.last - at < reach &&
         joined(span.last, span.last + 1)) {
    ++span.last;
  }
  return span;
}

/// The direction across a run of points, towards the sensor; zero where they are no line.
Point2 normal_of(const std::vector<ScanPoint>& points, const Span& span, const Point2& sensor) {
  const std::size_t count = span.last - span.first + 1;
  if (count < kMinPoints) return Point2::Zero();
  Point2 mean = Point2::Zero();
  for (std::size_t i = span.first; i <= span.last; ++i) mean += points[i].position;
  mean /= static_cast<double>(count);
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (std::size_t i = span.first; i <= span.last; ++i) {
    const Point2 off = points[i].position - mean;
    xx += off.x() * off.x();
    xy += off.x() * off.y();
    yy += off.y() * off.y();
  }
  const double half_trace = (xx + yy) / 2.0;
  const double root = std::hypot((xx - yy) / 2.0, xy);
  const double along = half_trace + root;
  const double across = std::max(0.0, half_trace - root);
  const bool is_rough = across / static_cast<double>(count) > kStraightM * kStraightM;
  if (across > (is_rough ? kRoughFlatness : kMaxFlatness) * along) return Point2::Zero();
  const Point2 normal = direction(std::atan2(2.0 * xy, xx - yy) / 2.0 + kPi / 2.0);
  return normal.dot(sensor - mean) < 0.0 ? Point2(-normal) : normal;
}

}  // namespace

Scan scan_of(const RangeReading& reading, const ScanOptions& options) {
  const RangeSensor& sensor = *reading.sensor;
  Scan scan;
  if (sensor.robot_from_beam.empty()) return scan;
  scan.sensor = sensor.robot_from_beam[sensor.robot_from_beam.size() / 2].position();
  scan.points.reserve(reading.ranges_m.size());
  for (std::size_t i = 0; i < reading.ranges_m.size(); ++i) {
    const double range_m = reading.ranges_m[i];
    if (!std::isfinite(range_m) || range_m < options.min_range_m || range_m >= options.no_echo_m) {
      continue;
    }
    const bool is_hit = range_m < sensor.max_range_m && range_m <= options.max_hit_m;
    const double seen_m = std::min(range_m, options.max_hit_m);
    scan.points.push_back(
        {sensor.robot_from_beam[i] * Point2(seen_m, 0.0), Point2::Zero(), is_hit});
  }
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (!scan.points[i].is_hit) continue;
    scan.points[i].normal =
        normal_of(scan.points, surface_around(scan.points, i, options), scan.sensor);
  }
  return scan;
}

std::vector<ScanPoint> thinned(const std::vector<ScanPoint>& points, int max_points) {
  const std::size_t stride =
      std::max<std::size_t>(1, points.size() / static_cast<std::size_t>(max_points));
  std::vector<ScanPoint> some;
  for (std::size_t i = 0; i < points.size(); i += stride) some.push_back(points[i]);
  return some;
}

}  // namespace roomatlas
