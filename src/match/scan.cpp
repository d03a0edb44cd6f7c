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

constexpr std::size_t kMostBeside = 60;  // beams on each side: more cost time and tell the same

constexpr std::size_t kMostLasers = 16;
constexpr double kSamePlaceM = 1e-6;  // beams that start nearer to each other are one laser's

struct Span {
  std::size_t first = 0;
  std::size_t last = 0;  // included
};

/// How far to each side of a beam the surface is followed.
struct Reach {
  std::size_t beams = 0;  ///< so many in any case ...
  std::size_t most = 0;   ///< ... and up to so many ...
  double least_m = 0.0;   ///< ... while this is not reached
};

Reach reach_of(const RangeSensor& sensor, const ScanOptions& options) {
  const auto beams = static_cast<std::size_t>(options.normal_neighbors);
  const std::vector<Pose2>& at = sensor.robot_from_beam;
  const double apart_rad =
      at.size() > 1 ? std::abs(wrap_angle(at[1].theta_rad - at[0].theta_rad)) : kPi;
  const bool is_fine = apart_rad < options.fine_rad;
  return {beams, is_fine ? std::max(beams, kMostBeside) : beams, options.fine_reach_m};
}

/// The beams beside `at`, of its own laser, that lie on the same surface: each near the one before.
Span surface_around(const std::vector<ScanPoint>& points, const Span& laser, std::size_t at,
                    const Reach& reach, const ScanOptions& options) {
  const auto joined = [&](std::size_t a, std::size_t b) {
    return points[a].is_hit && points[b].is_hit &&
           (points[a].position - points[b].position).norm() < options.normal_gap_m;
  };
  const auto goes_on = [&](std::size_t end, std::size_t beams) {
    return beams < reach.beams ||
           (beams < reach.most &&
            (points[end].position - points[at].position).norm() < reach.least_m);
  };
  Span span{at, at};
  while (span.first > laser.first && goes_on(span.first, at - span.first) &&
         joined(span.first - 1, span.first)) {
    --span.first;
  }
  while (span.last < laser.last && goes_on(span.last, span.last - at) &&
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

/// Sets the directions of one laser's surfaces.
void set_normals(Scan& scan, const Span& laser, const Point2& sensor, const Reach& reach,
                 const ScanOptions& options) {
  for (std::size_t i = laser.first; i <= laser.last; ++i) {
    if (!scan.points[i].is_hit) continue;
    scan.points[i].normal =
        normal_of(scan.points, surface_around(scan.points, laser, i, reach, options), sensor);
  }
}

void add_point(Scan& scan, const Pose2& beam, double range_m, double max_range_m,
               const ScanOptions& options) {
  if (!std::isfinite(range_m) || range_m < options.min_range_m || range_m >= options.no_echo_m) {
    return;
  }
  const bool is_hit = range_m < max_range_m && range_m <= options.max_hit_m;
  const double seen_m = std::min(range_m, options.max_hit_m);
  scan.points.push_back({beam * Point2(seen_m, 0.0), Point2::Zero(), is_hit});
}

/// Where the lasers of a reading start; as a rule it has one.
std::vector<std::size_t> first_beams(const RangeSensor& sensor) {
  std::vector<std::size_t> firsts = {0};
  for (std::size_t i = 1; i < sensor.robot_from_beam.size(); ++i) {
    const Point2 apart =
        sensor.robot_from_beam[i].position() - sensor.robot_from_beam[i - 1].position();
    if (apart.norm() > kSamePlaceM) firsts.push_back(i);
  }
  return firsts;
}

}  // namespace

Scan scan_of(const RangeReading& reading, const ScanOptions& options) {
  const RangeSensor& sensor = *reading.sensor;
  Scan scan;
  if (sensor.robot_from_beam.empty()) return scan;
  std::vector<std::size_t> firsts = first_beams(sensor);
  if (firsts.size() > kMostLasers) firsts.resize(1);  // each beam has a place of its own
  const std::size_t middle = firsts.size() > 1 ? 0 : sensor.robot_from_beam.size() / 2;
  scan.sensor = sensor.robot_from_beam[middle].position();
  firsts.push_back(reading.ranges_m.size());
  const Reach reach = reach_of(sensor, options);
  scan.points.reserve(reading.ranges_m.size());
  for (std::size_t laser = 0; laser + 1 < firsts.size(); ++laser) {
    const std::size_t first_point = scan.points.size();
    const Point2 from = laser == 0 ? scan.sensor : sensor.robot_from_beam[firsts[laser]].position();
    if (laser > 0) scan.further.push_back({first_point, from});
    for (std::size_t i = firsts[laser]; i < firsts[laser + 1]; ++i) {
      add_point(scan, sensor.robot_from_beam[i], reading.ranges_m[i], sensor.max_range_m, options);
    }
    if (scan.points.size() == first_point) continue;
    set_normals(scan, {first_point, scan.points.size() - 1}, from, reach, options);
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
