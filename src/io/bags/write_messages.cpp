// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/write_messages.hpp"

namespace roomatlas::io {
namespace {

constexpr std::int64_t kNsPerS = 1'000'000'000;
constexpr int kCovarianceNumbers = 36;

void zeros(Serializer& out, int count) {
  for (int i = 0; i < count; ++i) out.number(0.0);
}

void write_header(Serializer& out, const HeaderMessage& header) {
  if (out.is_ros1()) out.number(std::uint32_t{0});  // its number, which nobody reads
  out.number(static_cast<std::uint32_t>(header.stamp_ns / kNsPerS));
  out.number(static_cast<std::uint32_t>(header.stamp_ns % kNsPerS));
  out.text(header.frame);
}

void write_float(Serializer& out, double value) { out.number(static_cast<float>(value)); }

void write_transform(Serializer& out, const Transform3& transform) {
  for (const double value : transform.translation) out.number(value);
  for (const double value : transform.rotation.coeffs()) out.number(value);  // x, y, z, w
}

void write_stamped(Serializer& out, const PoseMessage& message) {
  write_header(out, message.header);
  out.text(message.child_frame);
  write_transform(out, message.frame_from_child.value());
}

}  // namespace

void write_laser_scan(Serializer& out, const LaserScanMessage& scan) {
  const double gaps = scan.ranges_m.empty() ? 0.0 : static_cast<double>(scan.ranges_m.size() - 1);
  write_header(out, scan.header);
  write_float(out, scan.angle_min_rad);
  write_float(out, scan.angle_min_rad + gaps * scan.angle_increment_rad);
  write_float(out, scan.angle_increment_rad);
  write_float(out, scan.time_increment_s);
  write_float(out, scan.scan_time_s);
  write_float(out, scan.range_min_m);
  write_float(out, scan.range_max_m);
  out.count(scan.ranges_m.size());
  for (const float range_m : scan.ranges_m) out.number(range_m);
  out.count(0);  // intensities
}

void write_range(Serializer& out, const RangeMessage& range) {
  write_header(out, range.header);
  out.number(static_cast<std::uint8_t>(range.radiation));
  write_float(out, range.field_of_view_rad);
  write_float(out, range.min_range_m);
  write_float(out, range.max_range_m);
  out.number(range.range_m);
  if (!out.is_ros1()) write_float(out, 0.0);  // variance, since Iron; older readers stop before it
}

void write_odometry(Serializer& out, const OdometryMessage& odometry) {
  write_stamped(out, odometry.pose);
  zeros(out, kCovarianceNumbers);
  out.number(odometry.speed_m_per_s);
  zeros(out, 4);  // sideways, upwards, roll, pitch
  out.number(odometry.turn_rate_rad_per_s);
  zeros(out, kCovarianceNumbers);
}

void write_pose(Serializer& out, const PoseMessage& pose) {
  write_header(out, pose.header);
  write_transform(out, pose.frame_from_child.value());
}

void write_transforms(Serializer& out, const TransformsMessage& transforms) {
  out.count(transforms.size());
  for (const PoseMessage& transform : transforms) write_stamped(out, transform);
}

}  // namespace roomatlas::io
