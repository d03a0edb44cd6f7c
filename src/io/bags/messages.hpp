// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/message_cursor.hpp"
#include "bags/transform3.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace roomatlas::io {

// The messages that are read, as far as they are used. Each is read by one function, whatever the
// encoding; what is behind the last field that is used is not looked at.

struct HeaderMessage {
  std::int64_t stamp_ns = 0;
  std::string frame;  ///< without the leading '/' of older releases
};

/// sensor_msgs/LaserScan; sensor_msgs/MultiEchoLaserScan with each beam's first echo: the nearest
/// surface, which is what a plan's wall is, where later ones are what glass let through.
struct LaserScanMessage {
  HeaderMessage header;
  double angle_min_rad = 0.0;
  double angle_increment_rad = 0.0;
  double time_increment_s = 0.0;
  double scan_time_s = 0.0;
  double range_min_m = 0.0;
  double range_max_m = 0.0;
  std::vector<float> ranges_m;
};

/// sensor_msgs/Range
struct RangeMessage {
  HeaderMessage header;
  int radiation = 0;  ///< 0: ultrasound, 1: infrared
  double field_of_view_rad = 0.0;
  double min_range_m = 0.0;
  double max_range_m = 0.0;
  float range_m = 0.0F;
};

/// sensor_msgs/PointCloud2
struct CloudMessage {
  HeaderMessage header;
  std::uint32_t height = 0;  ///< rows; 1: no order
  std::uint32_t width = 0;
  std::vector<Eigen::Vector3f> points;  ///< in the header's frame, those that are finite
  bool has_coordinates = true;          ///< x, y and z are fields of the points
  /// Of each point, from the stamp; empty where no field tells times of a sweep.
  std::vector<float> times_s;
};

/// nav_msgs/Odometry, geometry_msgs/PoseStamped, PoseWithCovarianceStamped, TransformStamped
struct PoseMessage {
  HeaderMessage header;
  std::string child_frame;                     ///< where the message has one
  std::optional<Transform3> frame_from_child;  ///< none where its numbers cannot be meant
};

/// tf2_msgs/TFMessage, tf/tfMessage
using TransformsMessage = std::vector<PoseMessage>;

/// sensor_msgs/Imu
struct ImuMessage {
  HeaderMessage header;
  Eigen::Vector3d turn_rad_per_s = Eigen::Vector3d::Zero();
  bool has_gyro = true;
};

/// What can be done with a message.
enum class MessageKind { laser, echoes, range, cloud, odometry, pose, transform, transforms, imu };

/// By type: "sensor_msgs/LaserScan", whatever stands between package and name ("msg").
[[nodiscard]] std::optional<MessageKind> kind_of_message(std::string_view type);

/// Nothing where the bytes are fewer than the fields need, or their counts cannot be.
[[nodiscard]] std::optional<LaserScanMessage> read_laser_scan(MessageCursor in);
[[nodiscard]] std::optional<LaserScanMessage> read_echoes(MessageCursor in);
[[nodiscard]] std::optional<RangeMessage> read_range(MessageCursor in);
[[nodiscard]] std::optional<CloudMessage> read_cloud(MessageCursor in);
[[nodiscard]] std::optional<PoseMessage> read_odometry(MessageCursor in);
/// PoseStamped and PoseWithCovarianceStamped begin alike.
[[nodiscard]] std::optional<PoseMessage> read_pose(MessageCursor in);
[[nodiscard]] std::optional<PoseMessage> read_transform(MessageCursor in);
[[nodiscard]] std::optional<TransformsMessage> read_transforms(MessageCursor in);
[[nodiscard]] std::optional<ImuMessage> read_imu(MessageCursor in);
/// The header, with which all of these but `transforms` begin.
[[nodiscard]] std::optional<HeaderMessage> read_header(MessageCursor in);

/// What a message definition's text says against reading it as that kind: the first field that is
/// another than expected. Empty where it fits, or is no text of fields (IDL).
[[nodiscard]] std::string misfit_of(MessageKind kind, const std::string& type,
                                    const std::string& definition);

/// A frame's name without leading '/'.
[[nodiscard]] std::string frame_name(std::string name);
/// Seconds of a stamp, rounded once.
[[nodiscard]] double seconds(std::int64_t time_ns);

}  // namespace roomatlas::io
