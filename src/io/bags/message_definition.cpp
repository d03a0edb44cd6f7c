// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/messages.hpp"
#include "text/tokens.hpp"

#include <sstream>
#include <utility>

namespace roomatlas::io {
namespace {

struct Field {
  std::string type;  ///< without its package
  std::string name;
  bool operator==(const Field&) const = default;
};
using Fields = std::vector<Field>;

/// The fields as far as they are read.
Fields expected_fields(MessageKind kind, const std::string& type) {
  const Fields scan = {{"Header", "header"},          {"float32", "angle_min"},
                       {"float32", "angle_max"},      {"float32", "angle_increment"},
                       {"float32", "time_increment"}, {"float32", "scan_time"},
                       {"float32", "range_min"},      {"float32", "range_max"}};
  const auto with = [](Fields fields, const Field& last) {
    fields.push_back(last);
    return fields;
  };
  switch (kind) {
    case MessageKind::laser:
      return with(scan, {"float32[]", "ranges"});
    case MessageKind::echoes:
      return with(scan, {"LaserEcho[]", "ranges"});
    case MessageKind::range:
      return {{"Header", "header"},     {"uint8", "radiation_type"}, {"float32", "field_of_view"},
              {"float32", "min_range"}, {"float32", "max_range"},    {"float32", "range"}};
    case MessageKind::cloud:
      return {{"Header", "header"},       {"uint32", "height"},     {"uint32", "width"},
              {"PointField[]", "fields"}, {"bool", "is_bigendian"}, {"uint32", "point_step"},
              {"uint32", "row_step"},     {"uint8[]", "data"}};
    case MessageKind::odometry:
      return {{"Header", "header"}, {"string", "child_frame_id"}, {"PoseWithCovariance", "pose"}};
    case MessageKind::pose:
      return {{"Header", "header"},
              {type.ends_with("PoseStamped") ? "Pose" : "PoseWithCovariance", "pose"}};
    case MessageKind::transform:
      return {{"Header", "header"}, {"string", "child_frame_id"}, {"Transform", "transform"}};
    case MessageKind::transforms:
      return {{"TransformStamped[]", "transforms"}};
    case MessageKind::imu:
      return {{"Header", "header"},
              {"Quaternion", "orientation"},
              {"float64[9]", "orientation_covariance"},
              {"Vector3", "angular_velocity"},
              {"float64[9]", "angular_velocity_covariance"}};
  }
  return {};
}

/// The fields of the message itself, before those of the messages in it. Constants are none.
Fields fields_in(const std::string& definition) {
  Fields fields;
  std::istringstream lines(definition);
  for (std::string line; std::getline(lines, line) && !line.starts_with("===");) {
    line = line.substr(0, line.find('#'));
    if (!line.empty() && line.back() == '\r') line.pop_back();
    Tokens tokens(line);
    if (tokens.at_end() || line.find('=') != std::string::npos) continue;
    std::string type(tokens.next());
    type.erase(0, type.rfind('/') + 1);  // none: npos + 1 is 0
    fields.push_back({std::move(type), std::string(tokens.next())});
  }
  return fields;
}

}  // namespace

std::string misfit_of(MessageKind kind, const std::string& type, const std::string& definition) {
  if (definition.find('{') != std::string::npos) return "";  // IDL
  const Fields found = fields_in(definition);
  if (found.empty()) return "";
  const Fields expected = expected_fields(kind, type);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const std::string wanted = expected[i].type + " " + expected[i].name;
    if (i >= found.size()) return "expected " + wanted + ", found no more fields";
    if (found[i] == expected[i]) continue;
    return "expected " + wanted + ", found " + found[i].type + " " + found[i].name;
  }
  return "";
}

}  // namespace roomatlas::io
