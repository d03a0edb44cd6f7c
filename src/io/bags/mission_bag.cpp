// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/mission_bag.hpp"

#include "logs/beam_fan.hpp"
#include "text/numbers.hpp"

#include "roomatlas/core/issue.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomatlas::io {
namespace {

constexpr const char* kOdometryFrame = "odom";
constexpr const char* kRobotFrame = "base_link";
constexpr const char* kTruthFrame = "world";

/// To the nearest nanosecond, which a double of today's time is coarser than: it comes back as it
/// was.
std::int64_t stamp_of(double time_s, const std::string& file) {
  constexpr double kMost_s = 2147483647.0;  // of 31 bits, in which ROS 2 counts
  if (!(time_s >= 0.0 && time_s < kMost_s)) {
    throw InputError(file + ": a reading is at " + shown(time_s) +
                     " s, which a recording's stamp cannot hold: expected seconds since 1970, from "
                     "0 to 2147483647; a CARMEN log (.clf) takes any");
  }
  const double whole_s = std::floor(time_s);
  return static_cast<std::int64_t>(whole_s) * 1'000'000'000 +
         std::llround((time_s - whole_s) * 1e9);
}

/// A quaternion rounds the heading: of those about the nearest, one from which the same bits are
/// read, so that a recording maps as the log of which it was made.
Transform3 told_upright(const Pose2& a_from_b) {
  constexpr int kTries = 8;  // steps of a double either way, of each of the two numbers
  Transform3 nearest = upright(a_from_b);
  for (int i = 0; i < (2 * kTries + 1) * (2 * kTries + 1); ++i) {
    const auto stepped = [](double value, int steps) {
      for (; steps != 0; steps -= steps > 0 ? 1 : -1) {
        value = std::nextafter(value, steps > 0 ? 2.0 : -2.0);
      }
      return value;
    };
    const auto around = [](int k) {
      return k % 2 == 0 ? k / 2 : -(k + 1) / 2;
    };  // 0, -1, 1, -2 ...
    Transform3 told = nearest;
    told.rotation.z() = stepped(told.rotation.z(), around(i / (2 * kTries + 1)));
    told.rotation.w() = stepped(told.rotation.w(), around(i % (2 * kTries + 1)));
    const auto read = sound_transform(told.translation, told.rotation);
    if (read && planar(*read).theta_rad == a_from_b.theta_rad) return told;
  }
  return nearest;
}

PoseMessage pose_at(std::int64_t stamp_ns, const char* frame, std::string child,
                    const Pose2& frame_from_child) {
  return {{stamp_ns, frame}, std::move(child), told_upright(frame_from_child)};
}

float told_range(float range_m, const RangeSensor& sensor) {
  if (!std::isfinite(range_m) || range_m <= 0.0F) return std::numeric_limits<float>::quiet_NaN();
  const bool is_within = range_m < static_cast<float>(sensor.max_range_m);
  return is_within ? range_m : std::numeric_limits<float>::infinity();
}

bool is_same_sensor(const RangeSensor& a, const RangeSensor& b) {
  return a.kind == b.kind && a.half_cone_rad == b.half_cone_rad && a.max_range_m == b.max_range_m &&
         a.robot_from_beam == b.robot_from_beam;
}

std::string numbered(const std::string& name, int number) {
  return number == 0 ? name : name + "_" + std::to_string(number + 1);
}

}  // namespace

MissionBag::MissionBag(std::unique_ptr<BagWriter> bag, std::string file)
    : bag_(std::move(bag)),
      file_(std::move(file)),
      encoding_(bag_->takes(BagEncoding::cdr) ? BagEncoding::cdr : BagEncoding::ros1) {}

void MissionBag::write(const OdometryStep& odometry) {
  const std::int64_t stamp_ns = stamp_of(odometry.timestamp_s, file_);
  const PoseMessage pose = pose_at(stamp_ns, kOdometryFrame, kRobotFrame, odometry.odom_from_robot);
  Serializer message(encoding_);
  write_odometry(message, {pose, odometry.speed_m_per_s, odometry.turn_rate_rad_per_s});
  put("/odom", "nav_msgs/Odometry", stamp_ns, message);
  Serializer transforms(encoding_);
  write_transforms(transforms, {pose});
  put("/tf", "tf2_msgs/TFMessage", stamp_ns, transforms);
}

void MissionBag::write(const RangeReading& reading) {
  require_a_range_a_beam(reading);
  const std::int64_t stamp_ns = stamp_of(reading.timestamp_s, file_);
  if (reading.sensor->kind == SensorKind::sonar) {
    return write_sonars(reading, meet(reading.sensor, stamp_ns), stamp_ns);
  }
  int laser = 0;
  for (const RangeReading& fan : fans_in(reading)) {
    write_scan(fan, meet(fan.sensor, stamp_ns), numbered("/scan", laser++), stamp_ns);
  }
}

void MissionBag::write(const TruePose& truth) {
  const std::int64_t stamp_ns = stamp_of(truth.timestamp_s, file_);
  Serializer message(encoding_);
  write_pose(message, pose_at(stamp_ns, kTruthFrame, kRobotFrame, truth.world_from_robot));
  put("/ground_truth", "geometry_msgs/PoseStamped", stamp_ns, message);
}

const MissionBag::Met& MissionBag::meet(const std::shared_ptr<const RangeSensor>& sensor,
                                        std::int64_t stamp_ns) {
  const auto known = known_.find(sensor.get());
  if (known != known_.end()) return *met_[known->second];
  for (const auto& met : met_) {
    if (is_same_sensor(met->sensor, *sensor)) return *met;
  }
  const std::size_t beams = sensor->robot_from_beam.size();
  auto met = std::make_unique<Met>(Met{*sensor, {}});
  if (sensor->kind == SensorKind::laser) {
    met->frames.push_back(numbered("laser", lasers_++));
  } else {
    const std::string ring = numbered("sonar", rings_++);
    for (std::size_t i = 0; i < beams; ++i) met->frames.push_back(ring + "_" + std::to_string(i));
  }
  Serializer transforms(encoding_);
  write_transforms(transforms, mounts_of(*met, stamp_ns));
  put("/tf_static", "tf2_msgs/TFMessage", stamp_ns, transforms);
  known_[sensor.get()] = met_.size();
  kept_.push_back(sensor);
  return *met_.emplace_back(std::move(met));
}

TransformsMessage MissionBag::mounts_of(const Met& met, std::int64_t stamp_ns) const {
  TransformsMessage mounts;
  const std::vector<Pose2>& beams = met.sensor.robot_from_beam;
  for (std::size_t i = 0; i < met.frames.size(); ++i) {
    // a laser's bearings are in its scans, so that it looks where the robot does
    const bool is_laser = met.sensor.kind == SensorKind::laser;
    const Pose2 mount = is_laser ? Pose2{beams[0].x_m, beams[0].y_m, 0.0} : beams[i];
    mounts.push_back(pose_at(stamp_ns, kRobotFrame, met.frames[i], mount));
  }
  return mounts;
}

void MissionBag::write_scan(const RangeReading& reading, const Met& met, const std::string& topic,
                            std::int64_t stamp_ns) {
  const BeamFan fan = fan_of(*reading.sensor).value();
  LaserScanMessage scan;
  scan.header = {stamp_ns, met.frames.front()};
  scan.angle_min_rad = fan.first_rad;
  scan.angle_increment_rad = fan.step_rad;
  scan.range_max_m = reading.sensor->max_range_m;
  for (const float range_m : reading.ranges_m) {
    scan.ranges_m.push_back(told_range(range_m, *reading.sensor));
  }
  Serializer message(encoding_);
  write_laser_scan(message, scan);
  put(topic, "sensor_msgs/LaserScan", stamp_ns, message);
}

void MissionBag::write_sonars(const RangeReading& reading, const Met& met, std::int64_t stamp_ns) {
  RangeMessage range;
  range.header.stamp_ns = stamp_ns;
  range.field_of_view_rad = 2.0 * reading.sensor->half_cone_rad;
  range.max_range_m = reading.sensor->max_range_m;
  for (std::size_t i = 0; i < met.frames.size(); ++i) {
    range.header.frame = met.frames[i];
    range.range_m = told_range(reading.ranges_m[i], *reading.sensor);
    Serializer message(encoding_);
    write_range(message, range);
    put("/" + met.frames[i], "sensor_msgs/Range", stamp_ns, message);
  }
}

void MissionBag::put(const std::string& topic, const char* type, std::int64_t stamp_ns,
                     const Serializer& message) {
  auto known = topics_.find(topic);
  if (known == topics_.end()) {
    const std::size_t index =
        bag_->add_topic({topic, type, encoding_, definition_of(type, encoding_), {}});
    known = topics_.emplace(topic, index).first;
  }
  recorded_ns_ = std::max(recorded_ns_, stamp_ns);
  bag_->write(known->second, recorded_ns_, message.bytes());
}

}  // namespace roomatlas::io
