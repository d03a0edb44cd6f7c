// SPDX-License-Identifier: GPL-3.0-or-later
// What a CARMEN source does with a message that was read.
#include "carmen_source.hpp"

#include "text/numbers.hpp"

#include <utility>
#include <variant>

namespace roomatlas::io {
namespace {

void add_leg(std::optional<Pose2>& last, const Pose2& pose, double& path_m) {
  if (last) path_m += (pose.position() - last->position()).norm();
  last = pose;
}

}  // namespace

void CarmenSource::use_message() {
  const CarmenTag& tag = *message_.tag;
  if (tag.kind == CarmenKind::parameter) return use_parameter();
  const std::optional<double> timestamp_s = timestamp_of_message();
  if (!timestamp_s) {
    const std::string field = std::string(tag.name) + " timestamp";
    return add_malformed(tag.name, {field, "expected a number, found the end of the line"});
  }
  ++info_.line_counts[std::string(tag.name)];
  note_state(*timestamp_s);
  if (tag.kind == CarmenKind::odometry) return use_odometry(*timestamp_s);
  if (tag.kind == CarmenKind::true_pose) return queue_.push(TruePose{*timestamp_s, message_.pose});
  use_scan(*timestamp_s);
}

std::optional<double> CarmenSource::timestamp_of_message() {
  if (!has_times_) info_.has_times = *(has_times_ = message_.timestamp_s.has_value());
  if (*has_times_) return message_.timestamp_s;
  if (message_.timestamp_s && !std::exchange(times_reported_, true)) {
    add_issue(Severity::warning, std::string(message_.tag->name) + " timestamp",
              "the log's first message has no timestamp but this line has one: times are not used. "
              "Delete the messages without");
  }
  return 0.0;
}

void CarmenSource::note_state(double timestamp_s) {
  TagState& state = tags_[message_.tag];
  state.trailing_fields = message_.trailing_fields;
  state.has_poses = message_.tag->kind == CarmenKind::laser && message_.scan.has_poses;
  if (!*has_times_) return;
  if (state.last_timestamp_s && timestamp_s < *state.last_timestamp_s) ++info_.steps_back_in_time;
  state.last_timestamp_s = timestamp_s;
  if (!info_.first_timestamp_s) info_.first_timestamp_s = timestamp_s;
  info_.last_timestamp_s = timestamp_s;
}

void CarmenSource::use_parameter() {
  if (std::string problem = parameters_.set(message_.name, message_.value); !problem.empty()) {
    return add_malformed("PARAM", {"PARAM " + message_.name, std::move(problem)});
  }
  ++info_.line_counts["PARAM"];
  info_.footprint.length_m = parameters_.robot_length_m.value_or(info_.footprint.length_m);
  info_.footprint.width_m = parameters_.robot_width_m.value_or(info_.footprint.width_m);
}

void CarmenSource::use_odometry(double timestamp_s) {
  add_leg(last_odometry_, message_.pose, odometry_path_m_);
  if (path_tag_ == nullptr) {
    info_.path_length_m = odometry_path_m_;
    info_.odometry = "ODOM lines";
  }
  const StampedPose line{timestamp_s, message_.pose};
  track_.add(line);
  queue_.see_odometry(line);
}

void CarmenSource::use_scan(double timestamp_s) {
  CarmenScan& scan = message_.scan;
  const bool filled =
      scan.has_poses && !(scan.odom_from_laser == Pose2{} && scan.odom_from_robot == Pose2{});
  if (filled && !std::exchange(scans_have_poses_, true)) queue_.believe_zero_poses();
  const bool pose_holds = scan.has_poses && scans_have_poses_;

  note_odd_scan();
  RangeReading reading;
  reading.timestamp_s = timestamp_s;
  reading.sensor = catalog_.sensor_of(*message_.tag, scan, parameters_, pose_holds);
  reading.ranges_m = scan.ranges_m;
  if (pose_holds) {
    reading.odom_from_robot = scan.odom_from_robot;
    use_scan_pose(timestamp_s);
    queue_.push(std::move(reading));
  } else if (const std::optional<Pose2> pose = track_.at(timestamp_s)) {
    reading.odom_from_robot = *pose;
    queue_.push(std::move(reading));
  } else {
    const auto wait =
        scan.has_poses ? EventQueue::Wait::zero_pose_on_line : EventQueue::Wait::no_pose_on_line;
    queue_.push(std::move(reading), AwaitedPose(timestamp_s, track_.newest()), wait);
  }
}

/// Without ODOM lines, the poses of scans are the odometry of readings that have none.
void CarmenSource::use_scan_pose(double timestamp_s) {
  const Pose2& pose = message_.scan.odom_from_robot;
  if (path_tag_ == nullptr) path_tag_ = message_.tag;
  if (path_tag_ == message_.tag) add_leg(last_path_scan_, pose, scan_path_m_);
  info_.path_length_m = scan_path_m_;
  info_.odometry = "poses in scans";
  if (last_odometry_) return;
  track_.add({timestamp_s, pose});
  queue_.see_odometry({timestamp_s, pose});
}

void CarmenSource::note_odd_scan() {
  const CarmenScan& scan = message_.scan;
  const bool sonar = message_.tag->kind == CarmenKind::sonar;
  if (!sonar && scan.directions_assumed && !std::exchange(directions_reported_, true)) {
    add_issue(Severity::warning, std::string(message_.tag->name) + " number of readings",
              std::to_string(scan.ranges_m.size()) +
                  " readings instead of 180, 181, 360 or 361: taken as spread evenly from -90 to "
                  "+90 degrees; where the scanner sees another angle the plan is wrong: write "
                  "ROBOTLASER1 lines, which have it");
  }
  const bool odd_cone = scan.cone_rad < 0.0 || scan.cone_rad >= kPi;
  if (sonar && odd_cone && !std::exchange(cone_reported_, true)) {
    const bool is_degrees = scan.cone_rad > 0.0 && scan.cone_rad < 180.0;
    add_issue(Severity::note, "SONAR cone_angle",
              "expected radians from 0 to pi, found " + shown(scan.cone_rad) + ": " +
                  (is_degrees ? "taken as degrees" : "--sonar-cone holds instead"));
  }
}

MissionEvent CarmenSource::hand_out(EventQueue::Taken taken) {
  const auto number = static_cast<double>(info_.readings);
  if (taken.without_odometry && !std::exchange(origin_reported_, true)) {
    add_issue(Severity::warning, "",
              "no odometry before or near a reading: its pose is taken as the origin. Record ODOM "
              "lines, or scans with poses");
  }
  if (auto* reading = std::get_if<RangeReading>(&taken.event)) {
    ++info_.readings;
    if (!info_.has_times) {
      reading->timestamp_s = number;
      if (!info_.first_timestamp_s) info_.first_timestamp_s = number;
      info_.last_timestamp_s = number;
    }
  } else {
    ++info_.true_poses;
    if (!info_.has_times) std::get<TruePose>(taken.event).timestamp_s = number;
  }
  return std::move(taken.event);
}

}  // namespace roomatlas::io
