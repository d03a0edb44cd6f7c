// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/laser_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomatlas::io {
namespace {

constexpr double kLongestSweepS = 1.0;  // more is no time of a laser
// A robot that moves and turns less than this in a sweep is taken for standing: what the beams are
// off by is less than the error of their ranges, and odometry of so short a time, which often lags,
// is no better.
constexpr double kStillM = 0.03;
constexpr double kStillRad = radians(1.0);
constexpr int kKnots = 16;  // poses of a sweep; between them straight

RangeLimits limits_of(const LaserScanMessage& scan, double trusted_m) {
  const bool has_max = std::isfinite(scan.range_max_m) && scan.range_max_m > 0.0;
  const bool has_min = std::isfinite(scan.range_min_m) && scan.range_min_m > 0.0;
  return {has_min ? scan.range_min_m : 0.0,
          has_max ? scan.range_max_m : std::numeric_limits<double>::infinity(), trusted_m};
}

/// Where the robot was in the course of a sweep, from where it was at the first beam.
class SweepPath {
 public:
  SweepPath(const RobotPoses& poses, std::int64_t start_ns, double sweep_s, std::size_t beams)
      : beams_(beams) {
    if (sweep_s <= 0.0 || beams < 2) return;
    const auto first = poses.odom_from_base(start_ns);
    if (!first) return;
    const Pose2 first_from_odom = inverse(planar(first->transform));
    for (int knot = 0; knot <= kKnots; ++knot) {
      const auto at_ns = start_ns + static_cast<std::int64_t>(1e9 * sweep_s * knot / kKnots);
      const auto pose = poses.odom_from_base(at_ns);
      knots_.push_back(first_from_odom * planar(pose->transform));
    }
  }

  [[nodiscard]] bool moves() const {
    return std::any_of(knots_.begin(), knots_.end(), [](const Pose2& pose) {
      return pose.position().norm() > kStillM || std::abs(pose.theta_rad) > kStillRad;
    });
  }

  [[nodiscard]] Pose2 at(std::size_t beam) const {
    const double place = kKnots * static_cast<double>(beam) / static_cast<double>(beams_ - 1);
    const auto before = std::min(static_cast<std::size_t>(place), std::size_t{kKnots - 1});
    return interpolate(knots_[before], knots_[before + 1], place - static_cast<double>(before));
  }

 private:
  std::size_t beams_;
  std::vector<Pose2> knots_;
};

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

/// The rays of a sweep from where the robot was at its first beam, counter-clockwise.
std::vector<SweepRay> rays_of(const LaserScanMessage& scan, const LaserShape& shape,
                              const RangeLimits& limits, const SweepPath* path) {
  std::vector<SweepRay> rays(shape.beams);
  const Point2 mount = shape.sensor->robot_from_beam.front().position();
  for (std::size_t i = 0; i < shape.beams; ++i) {
    const Echo echo = echo_of(scan.ranges_m[i], limits);
    const double range_m = echo == Echo::surface
                               ? shape.level_share[i] * static_cast<double>(scan.ranges_m[i])
                               : shape.sensor->max_range_m;
    const Pose2 moved = path != nullptr ? path->at(i) : Pose2{};
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

RangeReading LaserReader::read(std::size_t topic, const LaserScanMessage& scan,
                               std::int64_t stamp_ns, const Transform3& base_from_laser,
                               const RobotPoses& poses, bool has_odometry) {
  LaserShapes& shapes = shapes_[topic];
  const LaserShapes::Found found = shapes.find(scan, base_from_laser, trusted_m_);
  const LaserShape& shape = *found.shape;
  const RangeLimits limits = limits_of(scan, trusted_m_);
  note(scan, shape, limits);
  notes_.keeps_changing = notes_.keeps_changing || found.sensor != shape.sensor;

  RangeReading reading;
  reading.timestamp_s = seconds(stamp_ns);
  reading.sensor = found.sensor;
  if (const auto pose = poses.odom_from_base(stamp_ns)) {
    reading.odom_from_robot = planar(pose->transform);
  }
  const SweepPath path(poses, stamp_ns, has_odometry ? sweep_time_s(scan) : 0.0, shape.beams);
  const bool moves = path.moves();
  if (moves) ++notes_.unrolled;
  reading.ranges_m =
      moves || found.sensor != shape.sensor
          ? resampled(rays_of(scan, shape, limits, moves ? &path : nullptr), *found.sensor)
          : plain_ranges(scan, shape, limits);
  return reading;
}

}  // namespace roomatlas::io
