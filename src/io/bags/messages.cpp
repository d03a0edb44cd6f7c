// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/messages.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace roomatlas::io {
namespace {

constexpr std::int64_t kNsPerS = 1'000'000'000;

HeaderMessage header(MessageCursor& in) {
  HeaderMessage header;
  if (in.is_ros1()) (void)in.number<std::uint32_t>();  // its number, which ROS 2 has not
  const std::int64_t s = in.is_ros1() ? std::int64_t{in.number<std::uint32_t>()}
                                      : std::int64_t{in.number<std::int32_t>()};
  header.stamp_ns = s * kNsPerS + std::int64_t{in.number<std::uint32_t>()};
  header.frame = frame_name(in.text());
  return header;
}

/// One range a beam; a beam without echo has none.
std::vector<float> first_echoes(MessageCursor& in) {
  std::vector<float> firsts(in.count(sizeof(std::uint32_t)));
  for (float& first : firsts) {
    const std::vector<float> echoes = in.numbers<float>();
    first = echoes.empty() ? std::nanf("") : echoes.front();
  }
  return firsts;
}

/// An angle as it was before a float rounded it, where it was a whole number of ten-thousandths of
/// a degree, as those of most lasers are: a quarter of a degree is then one, over the whole sweep.
double angle(MessageCursor& in) {
  constexpr double kPartsOfDegree = 1e4;
  const float rounded_rad = in.number<float>();
  const double parts = std::round(degrees(static_cast<double>(rounded_rad)) * kPartsOfDegree);
  const double whole_rad = radians(parts / kPartsOfDegree);
  return static_cast<float>(whole_rad) == rounded_rad ? whole_rad
                                                      : static_cast<double>(rounded_rad);
}

/// All of a laser scan but its ranges, which MultiEchoLaserScan has in another shape.
LaserScanMessage scan_without_ranges(MessageCursor& in) {
  LaserScanMessage scan;
  scan.header = header(in);
  scan.angle_min_rad = angle(in);
  (void)in.number<float>();  // angle_max: follows from the number of beams
  scan.angle_increment_rad = angle(in);
  scan.time_increment_s = static_cast<double>(in.number<float>());
  scan.scan_time_s = static_cast<double>(in.number<float>());
  scan.range_min_m = static_cast<double>(in.number<float>());
  scan.range_max_m = static_cast<double>(in.number<float>());
  return scan;
}

Eigen::Vector3d vector(MessageCursor& in) {
  Eigen::Vector3d vector;
  for (double& value : vector) value = in.number<double>();
  return vector;
}

/// x, y, z, w.
Eigen::Quaterniond quaternion(MessageCursor& in) {
  std::array<double, 4> xyzw{};
  for (double& value : xyzw) value = in.number<double>();
  return {xyzw[3], xyzw[0], xyzw[1], xyzw[2]};
}

std::optional<Transform3> transform(MessageCursor& in) {
  const Eigen::Vector3d translation = vector(in);
  return sound_transform(translation, quaternion(in));
}

PoseMessage stamped_transform(MessageCursor& in) {
  PoseMessage message;
  message.header = header(in);
  message.child_frame = frame_name(in.text());
  message.frame_from_child = transform(in);
  return message;
}

template <typename Message>
std::optional<Message> if_whole(const MessageCursor& in, Message message) {
  if (in.failed()) return std::nullopt;
  return message;
}

}  // namespace

std::string frame_name(std::string name) {
  name.erase(0, name.find_first_not_of('/'));
  return name;
}

double seconds(std::int64_t time_ns) {
  const std::int64_t whole_s = time_ns / kNsPerS;
  return static_cast<double>(whole_s) +
         static_cast<double>(time_ns - whole_s * kNsPerS) / static_cast<double>(kNsPerS);
}

std::optional<MessageKind> kind_of_message(std::string_view type) {
  static constexpr std::array<std::pair<std::string_view, MessageKind>, 11> kKinds = {{
      {"sensor_msgs/LaserScan", MessageKind::laser},
      {"sensor_msgs/MultiEchoLaserScan", MessageKind::echoes},
      {"sensor_msgs/Range", MessageKind::range},
      {"sensor_msgs/PointCloud2", MessageKind::cloud},
      {"nav_msgs/Odometry", MessageKind::odometry},
      {"geometry_msgs/PoseStamped", MessageKind::pose},
      {"geometry_msgs/PoseWithCovarianceStamped", MessageKind::pose},
      {"geometry_msgs/TransformStamped", MessageKind::transform},
      {"tf2_msgs/TFMessage", MessageKind::transforms},
      {"tf/tfMessage", MessageKind::transforms},
      {"sensor_msgs/Imu", MessageKind::imu},
  }};
  const std::size_t package_end = type.find('/');
  const std::size_t name_begin = type.rfind('/');
  if (package_end == std::string_view::npos) return std::nullopt;
  const std::string plain =
      std::string(type.substr(0, package_end)) + std::string(type.substr(name_begin));
  for (const auto& [known, kind] : kKinds) {
    if (known == plain) return kind;
  }
  return std::nullopt;
}

std::optional<HeaderMessage> read_header(MessageCursor in) {
  HeaderMessage message = header(in);
  return if_whole(in, std::move(message));
}

std::optional<LaserScanMessage> read_laser_scan(MessageCursor in) {
  LaserScanMessage scan = scan_without_ranges(in);
  scan.ranges_m = in.numbers<float>();
  return if_whole(in, std::move(scan));
}

std::optional<LaserScanMessage> read_echoes(MessageCursor in) {
  LaserScanMessage scan = scan_without_ranges(in);
  scan.ranges_m = first_echoes(in);
  return if_whole(in, std::move(scan));
}

std::optional<RangeMessage> read_range(MessageCursor in) {
  RangeMessage message;
  message.header = header(in);
  message.radiation = in.number<std::uint8_t>();
  message.field_of_view_rad = angle(in);
  message.min_range_m = static_cast<double>(in.number<float>());
  message.max_range_m = static_cast<double>(in.number<float>());
  message.range_m = in.number<float>();
  return if_whole(in, std::move(message));
}

std::optional<PoseMessage> read_odometry(MessageCursor in) {
  PoseMessage message = stamped_transform(in);  // a pose has the fields of a transform
  return if_whole(in, std::move(message));
}

std::optional<PoseMessage> read_transform(MessageCursor in) { return read_odometry(in); }

std::optional<PoseMessage> read_pose(MessageCursor in) {
  PoseMessage message;
  message.header = header(in);
  message.frame_from_child = transform(in);
  return if_whole(in, std::move(message));
}

std::optional<TransformsMessage> read_transforms(MessageCursor in) {
  constexpr std::size_t kLeastBytes = 70;  // two empty names, a stamp, seven numbers
  TransformsMessage messages(in.count(kLeastBytes));
  for (PoseMessage& message : messages) message = stamped_transform(in);
  return if_whole(in, std::move(messages));
}

std::optional<ImuMessage> read_imu(MessageCursor in) {
  constexpr int kCovariance = 9;
  ImuMessage message;
  message.header = header(in);
  (void)quaternion(in);
  for (int i = 0; i < kCovariance; ++i) (void)in.number<double>();
  message.turn_rad_per_s = vector(in);
  message.has_gyro = in.number<double>() != -1.0;  // so its covariance says by the definition
  return if_whole(in, std::move(message));
}

}  // namespace roomatlas::io
