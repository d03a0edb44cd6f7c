// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/laser_shapes.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas::io {
namespace {

// Nearer than this a shape is the one before: below what mounts are known to.
constexpr double kSameM = 1e-3;
constexpr double kSameRad = 1e-4;
constexpr double kFullTurnRad = 2.0 * kPi + 0.2;  // some lasers close the circle twice
constexpr double kNoTiltRad = radians(0.5);       // of tilt: ranges are what they are

bool is_alike(const LaserShape& shape, const LaserScanMessage& scan,
              const Transform3& base_from_laser, double range_max_m) {
  const double spans_rad = scan.angle_increment_rad - shape.angle_increment_rad;
  return shape.beams == scan.ranges_m.size() &&
         std::abs(shape.angle_min_rad - scan.angle_min_rad) < kSameRad &&
         std::abs(spans_rad) * static_cast<double>(shape.beams) < kSameRad &&
         std::abs(shape.range_max_m - range_max_m) < kSameM &&
         (shape.base_from_laser.translation - base_from_laser.translation).norm() < kSameM &&
         shape.base_from_laser.rotation.angularDistance(base_from_laser.rotation) < kSameRad;
}

Eigen::Vector3d beam_direction(const LaserShape& shape, std::size_t beam) {
  const double angle_rad =
      shape.angle_min_rad + static_cast<double>(beam) * shape.angle_increment_rad;
  return shape.base_from_laser.rotation *
         Eigen::Vector3d(std::cos(angle_rad), std::sin(angle_rad), 0.0);
}

void describe(LaserShape& shape) {
  const Eigen::Vector3d up = shape.base_from_laser.rotation * Eigen::Vector3d::UnitZ();
  shape.is_upside_down = up.z() < 0.0;
  shape.tilt_rad = std::acos(std::min(1.0, std::abs(up.z())));
  shape.is_reversed = shape.is_upside_down != (shape.angle_increment_rad < 0.0);
  RangeSensor sensor;
  sensor.max_range_m = static_cast<double>(static_cast<float>(shape.range_max_m));
  sensor.robot_from_beam.resize(shape.beams);
  shape.level_share.assign(shape.beams, 1.0);
  const Pose2 mount = planar(shape.base_from_laser);
  for (std::size_t i = 0; i < shape.beams; ++i) {
    const Eigen::Vector3d ray = beam_direction(shape, i);
    if (shape.tilt_rad > kNoTiltRad) shape.level_share[i] = std::hypot(ray.x(), ray.y());
    const double angle_rad =
        shape.angle_min_rad + static_cast<double>(i) * shape.angle_increment_rad;
    const double level_rad = mount.theta_rad + (shape.is_upside_down ? -angle_rad : angle_rad);
    const bool is_level = shape.tilt_rad <= kNoTiltRad;
    const double bearing_rad = is_level ? level_rad : std::atan2(ray.y(), ray.x());
    sensor.robot_from_beam[shape.sensor_beam(i)] = {mount.x_m, mount.y_m, wrap_angle(bearing_rad)};
  }
  shape.sensor = std::make_shared<const RangeSensor>(std::move(sensor));
}

}  // namespace

Point2 LaserShape::direction_of(std::size_t scan_beam) const {
  return roomatlas::direction(sensor->robot_from_beam[sensor_beam(scan_beam)].theta_rad);
}

std::string problem_of(const LaserScanMessage& scan) {
  if (scan.ranges_m.empty()) return "it has no beams";
  const double span_rad = scan.angle_increment_rad * static_cast<double>(scan.ranges_m.size() - 1);
  if (!std::isfinite(scan.angle_min_rad) || !std::isfinite(span_rad)) {
    return "its angles are no finite numbers";
  }
  if (std::abs(span_rad) > kFullTurnRad) return "its beams span more than a turn";
  if (scan.ranges_m.size() > 1 && span_rad == 0.0) return "all its beams point the same way";
  return "";
}

LaserShapes::Found LaserShapes::find(const LaserScanMessage& scan,
                                     const Transform3& base_from_laser, double trusted_m) {
  const bool has_max = std::isfinite(scan.range_max_m) && scan.range_max_m > 0.0;
  const double range_max_m = has_max ? std::min(scan.range_max_m, trusted_m) : trusted_m;
  for (const LaserShape& shape : shapes_) {
    if (is_alike(shape, scan, base_from_laser, range_max_m)) return {&shape, shape.sensor, false};
  }
  if (!is_alike(passing_, scan, base_from_laser, range_max_m)) {
    passing_ = {};
    passing_.beams = scan.ranges_m.size();
    passing_.angle_min_rad = scan.angle_min_rad;
    passing_.angle_increment_rad = scan.angle_increment_rad;
    passing_.range_max_m = range_max_m;
    passing_.base_from_laser = base_from_laser;
    describe(passing_);
  }
  if (keeps_changing()) return {&passing_, shapes_.front().sensor, false};
  shapes_.push_back(passing_);
  return {&shapes_.back(), shapes_.back().sensor, true};
}

}  // namespace roomatlas::io
