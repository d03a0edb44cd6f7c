// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/messages.hpp"
#include "bags/serializer.hpp"

#include <string>

namespace roomatlas::io {

// The messages that are written, each by one function, whatever the encoding. Fields of which
// nothing is known, such as covariances, are zero.

/// nav_msgs/Odometry
struct OdometryMessage {
  PoseMessage pose;  ///< with its child frame
  double speed_m_per_s = 0.0;
  double turn_rate_rad_per_s = 0.0;
};

void write_laser_scan(Serializer& out, const LaserScanMessage& scan);
void write_range(Serializer& out, const RangeMessage& range);
void write_odometry(Serializer& out, const OdometryMessage& odometry);
void write_pose(Serializer& out, const PoseMessage& pose);
void write_transforms(Serializer& out, const TransformsMessage& transforms);

/// The text of a type's definition with those of the types in it, in the release's words that goes
/// with the encoding. Types: sensor_msgs/LaserScan and Range, nav_msgs/Odometry,
/// geometry_msgs/PoseStamped, tf2_msgs/TFMessage. Throws std::out_of_range for another.
[[nodiscard]] std::string definition_of(const std::string& type, BagEncoding encoding);

}  // namespace roomatlas::io
