// SPDX-License-Identifier: GPL-3.0-or-later
#include "carmen_parser.hpp"

#include "field_reader.hpp"
#include "roomatlas/mission/plausible.hpp"
#include "text/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace roomatlas::io {
namespace {

constexpr std::size_t kTrailerFields = 3;  // timestamp, host, logger time
constexpr std::size_t kPoseFields = 6;     // laser and robot

/// The end of a line: nothing, or a timestamp that a host and the logger's time may follow.
void read_trailer(FieldReader& fields, CarmenMessage& message) {
  message.timestamp_s.reset();
  message.trailing_fields = static_cast<int>(fields.fields_left());
  if (fields.fields_left() == 0) return;
  if (fields.fields_left() > kTrailerFields) {
    fields.fail("", std::string(message.tag->name) + " has " +
                        std::to_string(fields.fields_left() - kTrailerFields) +
                        " fields too many before its timestamp");
  }
  message.timestamp_s = fields.number("timestamp");
}

/// Reads both poses where the line goes on for at least as many fields.
void read_scan_poses(FieldReader& fields, CarmenScan& scan) {
  scan.has_poses = fields.fields_left() >= kPoseFields;
  if (!scan.has_poses) return;
  scan.odom_from_laser = fields.pose("laser x", "laser y", "laser theta");
  scan.odom_from_robot = fields.pose("robot x", "robot y", "robot theta");
  const double apart_m = (scan.odom_from_laser.position() - scan.odom_from_robot.position()).norm();
  if (apart_m > kFarthestMount_m) {
    fields.fail("laser and robot pose",
                "expected the laser at most 10 m from the robot's centre, "
                "found it " +
                    shown(apart_m) + " m away");
  }
}

/// FLASER and RLASER say nothing about directions: the scanners of that time swept 180 degrees from
/// right to left, and those with an even number of readings left the last direction out.
void set_directions_by_count(CarmenScan& scan) {
  const std::size_t count = scan.ranges_m.size();
  scan.directions_assumed = false;
  scan.start_rad = radians(-90.0);
  if (count == 180 || count == 181) {
    scan.step_rad = radians(1.0);
  } else if (count == 360 || count == 361) {
    scan.step_rad = radians(0.5);
  } else {
    scan.directions_assumed = true;
    scan.step_rad = count > 1 ? radians(180.0) / static_cast<double>(count - 1) : 0.0;
    if (count == 1) scan.start_rad = 0.0;
  }
}

/// FLASER n r1..rn [x y theta odom_x odom_y odom_theta] [timestamp [host [logger_time]]]
void read_old_laser(FieldReader& fields, CarmenMessage& message) {
  CarmenScan& scan = message.scan;
  fields.ranges(scan.ranges_m);
  const std::size_t left = fields.fields_left();
  const bool has_poses = left >= kPoseFields && left <= kPoseFields + kTrailerFields;
  if (left != 0 && !has_poses && !fields.is_trailer()) fields.fail_announced();
  read_scan_poses(fields, scan);
  set_directions_by_count(scan);
  scan.max_range_m = 0.0;
}

/// Angles in degrees would spread the readings over many turns.
void check_directions(FieldReader& fields, const CarmenScan& scan) {
  constexpr double kMost_rad = 2.2 * kPi;  // a turn, and what a scanner sees twice of it
  if (std::abs(scan.start_rad) > kMost_rad) {
    fields.fail("start_angle", "expected radians, found " + shown(scan.start_rad) +
                                   ", more than a turn, which looks like degrees");
  }
  const std::size_t gaps = std::max<std::size_t>(scan.ranges_m.size(), 1) - 1;
  const double covered_rad = std::abs(scan.step_rad) * static_cast<double>(gaps);
  if (covered_rad > kMost_rad) {
    fields.fail("fov, step", "expected radians, found " + std::to_string(gaps + 1) + " readings " +
                                 shown(scan.step_rad) +
                                 " apart, more than a turn, which looks like degrees");
  }
}

/// type start_angle fov step max_range accuracy remission_mode n r1..rn [m remission1..m]
void read_laser_body(FieldReader& fields, CarmenScan& scan) {
  (void)fields.number("type");
  scan.start_rad = fields.number("start_angle");
  const double fov_rad = fields.number("fov");
  scan.step_rad = fields.number("step");
  scan.max_range_m = fields.number("max_range");
  (void)fields.number("accuracy");
  (void)fields.number("remission_mode");
  fields.ranges(scan.ranges_m);
  if (!fields.at_end()) fields.skip_counted("remission");
  scan.directions_assumed = false;
  const std::size_t count = scan.ranges_m.size();
  if (scan.step_rad == 0.0 && count > 1) {
    scan.step_rad = fov_rad / static_cast<double>(count - 1);
    if (fov_rad == 0.0) fields.fail("step", "expected an angle between beams, found 0");
  }
  check_directions(fields, scan);
}

/// ... laser_x .. robot_theta tv rv forward_safety side_safety turn_axis timestamp host logger_time
void read_robot_laser(FieldReader& fields, CarmenMessage& message) {
  constexpr std::size_t kMotionFields = 5;  // tv, rv, forward_safety, side_safety, turn_axis
  read_laser_body(fields, message.scan);
  read_scan_poses(fields, message.scan);
  if (message.scan.has_poses && fields.fields_left() >= kMotionFields) {
    for (std::size_t i = 0; i < kMotionFields; ++i) (void)fields.number("tv .. turn_axis");
  }
}

/// SONAR cone_angle num_sonars r1..rn (x y theta)1..n
void read_sonar(FieldReader& fields, CarmenScan& scan) {
  scan.has_poses = false;
  scan.cone_rad = fields.number("cone_angle");
  fields.ranges(scan.ranges_m);
  const std::size_t left = fields.fields_left();
  if (left < 3 * scan.ranges_m.size() || left > 3 * scan.ranges_m.size() + kTrailerFields) {
    fields.fail_announced();
  }
  scan.robot_from_sonar.clear();
  for (std::size_t i = 0; i < scan.ranges_m.size() && !fields.problem(); ++i) {
    scan.robot_from_sonar.push_back(fields.mount("offset x", "offset y", "offset theta"));
  }
}

void read_laser(FieldReader& fields, CarmenMessage& message) {
  if (message.tag->name.starts_with("ROBOT")) return read_robot_laser(fields, message);
  if (!message.tag->name.starts_with("RAW")) return read_old_laser(fields, message);
  read_laser_body(fields, message.scan);
  message.scan.has_poses = false;
}

/// ODOM x y theta [tv rv accel]: old tools leave the motion out.
void read_odometry(FieldReader& fields, CarmenMessage& message) {
  message.pose = fields.pose("x", "y", "theta");
  if (fields.at_end()) return;
  (void)fields.number("tv");
  (void)fields.number("rv");
  (void)fields.number("accel");
}

void read_parameter(FieldReader& fields, CarmenMessage& message) {
  message.name = fields.word();
  message.value = fields.word();
  message.timestamp_s.reset();
  if (message.name.empty()) fields.fail("name", "expected a name, found the end of the line");
}

}  // namespace

std::optional<CarmenProblem> parse_carmen_line(const CarmenTag& tag, std::string_view line,
                                               CarmenMessage& message) {
  FieldReader fields(tag.name, line);
  message.tag = &tag;
  switch (tag.kind) {
    case CarmenKind::odometry:
      read_odometry(fields, message);
      break;
    case CarmenKind::laser:
      read_laser(fields, message);
      break;
    case CarmenKind::sonar:
      read_sonar(fields, message.scan);
      break;
    case CarmenKind::true_pose:
      message.pose = fields.pose("true_x", "true_y", "true_theta");
      (void)fields.pose("odom_x", "odom_y", "odom_theta");
      break;
    case CarmenKind::parameter:
      read_parameter(fields, message);
      return fields.problem();
  }
  read_trailer(fields, message);
  return fields.problem();
}

}  // namespace roomatlas::io
