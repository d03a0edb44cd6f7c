// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/laser_reader.hpp"

#include "bags/sweep_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomatlas::io {
namespace {

constexpr double kLongestSweepS = 1.0;  // more is no time of a laser

RangeLimits limits_of(const LaserScanMessage& scan, double trusted_m) {
  const bool has_max = std::isfinite(scan.range_max_m) && scan.range_max_m > 0.0;
  const bool has_min = std::isfinite(scan.range_min_m) && scan.range_min_m > 0.0;
  return {has_min ? scan.range_min_m : 0.0,
          has_max ? scan.range_max_m : std::numeric_limits<double>::infinity(), trusted_m};
}

/// The sensor's ranges as the scan has them.
std::vector<float> plain_ranges(const LaserScanMessage& scan, const LaserShape& shape,
                                const RangeLimits& limits) {
  std::vector<float> ranges_m(shape.beams, std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < shape.beams; ++i) {
    float& range_m = ranges_m[shape.sensor_beam(i)];
    const Echo echo = echo_of(scan.ranges_m[i], limits);
    if (echo == Echo::nothing) range_m = static_cast<float>(shape.sensor->max_range_m);
    if (echo != Echo::surface) continue;
    const double share = shape.level_share[i];
    range_m = share == 1.0 ? scan.ranges_m[i]
                           : static_cast<float>(share * static_cast<double>(scan.ranges_m[i]));
  }
  return ranges_m;
}

/// Of a sweep's time that has passed at a beam.
double share_of(std::size_t beam, std::size_t beams, double order) {
  const double place = beams > 1 ? static_cast<double>(beam) / static_cast<double>(beams - 1) : 0.0;
  return order < 0.0 ? 1.0 - place : place;
}

/// The rays of a sweep from where the robot was at its first beam, counter-clockwise.
std::vector<SweepRay> rays_of(const LaserScanMessage& scan, const LaserShape& shape,
                              const RangeLimits& limits, const SweepPath* path, double order) {
  std::vector<SweepRay> rays(shape.beams);
  const Point2 mount = shape.sensor->robot_from_beam.front().position();
  for (std::size_t i = 0; i < shape.beams; ++i) {
    const Echo echo = echo_of(scan.ranges_m[i], limits);
    const double range_m = echo == Echo::surface
                               ? shape.level_share[i] * static_cast<double>(scan.ranges_m[i])
                               : shape.sensor->max_range_m;
    const Pose2 moved = path != nullptr ? path->at(share_of(i, shape.beams, order)) : Pose2{};
    rays[shape.sensor_beam(i)] = {moved * mount,
                                  moved * Point2(mount + range_m * shape.direction_of(i)), echo};
  }
  return rays;
}

}  // namespace

double sweep_time_s(const LaserScanMessage& scan) {
  const auto steps = static_cast<double>(scan.ranges_m.size()) - 1.0;
  const auto is_sound = [](double sweep_s) { return sweep_s > 0.0 && sweep_s <= kLongestSweepS; };
  const double by_increment_s = scan.time_increment_s * steps;
  if (is_sound(by_increment_s)) return by_increment_s;
  if (scan.time_increment_s != 0.0) return 0.0;
  const double by_turn_s =
      scan.scan_time_s * std::abs(scan.angle_increment_rad) * steps / (2.0 * kPi);
  return is_sound(by_turn_s) ? by_turn_s : 0.0;
}

void LaserReader::note(const LaserScanMessage& scan, const LaserShape& shape,
                       const RangeLimits& limits) {
  ++notes_.sweeps;
  for (const float range_m : scan.ranges_m) notes_.echoes.add(range_m, limits);
  notes_.most_tilt_rad = std::max(notes_.most_tilt_rad, shape.tilt_rad);
  notes_.is_upside_down = notes_.is_upside_down || shape.is_upside_down;
}

RangeReading LaserReader::read(const Sweep& sweep, const RobotPoses& poses, bool has_odometry) {
  const LaserScanMessage& scan = sweep.scan;
  LaserShapes& shapes = shapes_[sweep.topic];
  const LaserShapes::Found found = shapes.find(scan, sweep.base_from_laser, trusted_m_);
  const LaserShape& shape = *found.shape;
  const RangeLimits limits = limits_of(scan, trusted_m_);
  note(scan, shape, limits);
  notes_.keeps_changing = notes_.keeps_changing || found.sensor != shape.sensor;

  RangeReading reading;
  reading.timestamp_s = seconds(sweep.reading_ns);
  reading.sensor = found.sensor;
  if (const auto pose = poses.odom_from_base(sweep.reading_ns)) {
    reading.odom_from_robot = planar(pose->transform);
  }
  const double sweep_s = std::abs(sweep.order) * sweep_time_s(scan);
  const std::int64_t end_ns =
      sweep.stamp_ns + (shape.beams > 1 ? static_cast<std::int64_t>(1e9 * sweep_s) : 0);
  const SweepPath path =
      has_odometry ? SweepPath(poses, sweep.reading_ns, sweep.stamp_ns, end_ns) : SweepPath();
  const bool moves = path.moves();
  if (moves) ++notes_.unrolled;
  const bool as_it_is = !moves && found.sensor == shape.sensor;
  if (!has_odometry && as_it_is)
    reading.sweep_s = (shape.is_reversed ? -sweep.order : sweep.order) * sweep_s;
  reading.ranges_m =
      as_it_is ? plain_ranges(scan, shape, limits)
               : resampled(rays_of(scan, shape, limits, moves ? &path : nullptr, sweep.order),
                           *found.sensor);
  return reading;
}

}  // namespace roomatlas::io
