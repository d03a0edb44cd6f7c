// SPDX-License-Identifier: GPL-3.0-or-later
// The fields of the messages that are written, as `rosmsg show` and `ros2 interface show` name
// them.
#include "bags/write_messages.hpp"

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

namespace roomatlas::io {
namespace {

using Definitions = std::map<std::string, std::string>;

const Definitions& common_definitions() {
  static const Definitions kCommon = {
      {"sensor_msgs/LaserScan",
       "std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max\nfloat32 angle_increment\n"
       "float32 time_increment\nfloat32 scan_time\nfloat32 range_min\nfloat32 range_max\n"
       "float32[] ranges\nfloat32[] intensities\n"},
      {"sensor_msgs/Range",
       "std_msgs/Header header\nuint8 ULTRASOUND=0\nuint8 INFRARED=1\nuint8 radiation_type\n"
       "float32 field_of_view\nfloat32 min_range\nfloat32 max_range\nfloat32 range\n"},
      {"nav_msgs/Odometry",
       "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/PoseWithCovariance pose\n"
       "geometry_msgs/TwistWithCovariance twist\n"},
      {"tf2_msgs/TFMessage", "geometry_msgs/TransformStamped[] transforms\n"},
      {"geometry_msgs/PoseStamped", "std_msgs/Header header\ngeometry_msgs/Pose pose\n"},
      {"geometry_msgs/TransformStamped",
       "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n"},
      {"geometry_msgs/Transform",
       "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n"},
      {"geometry_msgs/PoseWithCovariance", "geometry_msgs/Pose pose\nfloat64[36] covariance\n"},
      {"geometry_msgs/TwistWithCovariance", "geometry_msgs/Twist twist\nfloat64[36] covariance\n"},
      {"geometry_msgs/Pose",
       "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n"},
      {"geometry_msgs/Twist", "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n"},
      {"geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n"},
      {"geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n"},
      {"geometry_msgs/Quaternion", "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n"},
  };
  return kCommon;
}

Definitions definitions_for(BagEncoding encoding) {
  Definitions all = common_definitions();
  if (encoding == BagEncoding::ros1) {
    all["std_msgs/Header"] = "uint32 seq\ntime stamp\nstring frame_id\n";
    return all;
  }
  all["std_msgs/Header"] = "builtin_interfaces/Time stamp\nstring frame_id\n";
  all["builtin_interfaces/Time"] = "int32 sec\nuint32 nanosec\n";
  all["sensor_msgs/Range"] += "float32 variance\n";
  return all;
}

/// Types of other messages that a definition names, in order.
std::vector<std::string> types_in(const std::string& definition) {
  std::vector<std::string> types;
  std::istringstream lines(definition);
  for (std::string line; std::getline(lines, line);) {
    const std::string type = line.substr(0, line.find_first_of(" ["));
    if (type.find('/') != std::string::npos) types.push_back(type);
  }
  return types;
}

}  // namespace

std::string definition_of(const std::string& type, BagEncoding encoding) {
  const Definitions all = definitions_for(encoding);
  std::string text = all.at(type);
  std::vector<std::string> within = types_in(text);
  for (std::size_t i = 0; i < within.size(); ++i) {
    const std::string& definition = all.at(within[i]);
    text += std::string(80, '=') + "\nMSG: " + within[i] + "\n" + definition;
    for (const std::string& deeper : types_in(definition)) {
      if (std::count(within.begin(), within.end(), deeper) == 0) within.push_back(deeper);
    }
  }
  return text;
}

}  // namespace roomatlas::io
