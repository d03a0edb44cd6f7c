// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/bag_source.hpp"

#include "bags/gyro_trial.hpp"
#include "bags/mount_trial.hpp"
#include "bags/order_trial.hpp"
#include "bags/recorded_poses.hpp"
#include "text/numbers.hpp"

#include "roomatlas/io/text/utf8.hpp"
#include "roomatlas/mission/plausible.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace roomatlas::io {
namespace {

constexpr std::int64_t kNear_ns = 500'000'000;  // so old a pose still holds: half a second

}  // namespace

std::optional<Pose2> mount_in(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const std::vector<std::string> parts = names_in(text);
  std::array<double, 3> numbers{};
  bool sound = parts.size() == numbers.size();
  for (std::size_t i = 0; sound && i < numbers.size(); ++i) {
    const auto number = parse_number(parts[i]);
    sound = number && std::isfinite(*number) && std::abs(*number) <= 360.0;
    numbers[i] = number.value_or(0.0);
  }
  if (!sound || std::hypot(numbers[0], numbers[1]) > kFarthestMount_m) {
    throw UsageError("--laser-mount " + text +
                     ": expected x,y,deg: at most 10 m from the robot's centre, and the direction "
                     "in which it looks, counter-clockwise from ahead");
  }
  return Pose2{numbers[0], numbers[1], wrap_angle(radians(numbers[2]))};
}

BagSource::BagSource(std::string name, const OpenRecording& open, const MissionOptions& options)
    : options_(options), lasers_(options.laser_max_range_m) {
  Survey beginning = survey(*open());
  TopicChoice choice = choose_topics(beginning, options.recording, name);
  find_mount(choice, beginning, open, options, name);
  choose_beam_order(choice, beginning, open, options, name);
  choose_gyro(choice, beginning, open, options, name);
  start(std::move(name), open(), std::move(choice), beginning);
}

BagSource::BagSource(std::string name, std::unique_ptr<BagReader> reader,
                     const MissionOptions& options, TopicChoice choice, const Survey& beginning)
    : options_(options), lasers_(options.laser_max_range_m) {
  start(std::move(name), std::move(reader), std::move(choice), beginning);
}

void BagSource::start(std::string name, std::unique_ptr<BagReader> reader, TopicChoice choice,
                      const Survey& beginning) {
  reader_ = std::move(reader);
  choice_ = std::move(choice);
  const std::optional<Pose2> told = mount_in(options_.recording.laser_mount);
  const std::optional<Pose2> mount = told ? told : choice_.mount;
  poses_ = std::make_unique<RobotPoses>(choice_, beginning.frames, mount);
  ring_ = make_ring(beginning);
  if (choice_.is_one_reading) {
    group_ = LaserGroup({choice_.scans.begin() + 1, choice_.scans.end()}, choice_.half_period_ns);
  }
  meet_topics(beginning);
  evidence_ = beginning.evidence;
  info_.file = std::move(name);
  info_.format = reader_->format();
  info_.footprint = options_.footprint;
  switch (choice_.odometry) {
    case TopicChoice::Odometry::none:
      info_.odometry = "none";
      break;
    case TopicChoice::Odometry::topic:
      info_.odometry = reader_->topics()[choice_.odometry_topic].name;
      break;
    case TopicChoice::Odometry::transforms:
      info_.odometry = "tf " + choice_.odometry_frame + " -> " + choice_.odometry_child;
      break;
  }
  describe();
}

SonarRing BagSource::make_ring(const Survey& beginning) const {
  std::vector<SonarRing::Name> sonars;
  for (const std::size_t topic : choice_.ranges) {
    for (const std::string& frame : beginning.evidence[topic].frames) {
      sonars.emplace_back(topic, frame);
    }
  }
  return SonarRing(std::move(sonars));
}

void BagSource::meet_topics(const Survey& beginning) {
  topics_.resize(beginning.topics.size());
  std::vector<std::size_t> wanted;
  const auto has = [](const std::vector<std::size_t>& list, std::size_t i) {
    return std::count(list.begin(), list.end(), i) > 0;
  };
  for (std::size_t i = 0; i < topics_.size(); ++i) {
    Topic& topic = topics_[i];
    const TopicEvidence& evidence = beginning.evidence[i];
    if (!evidence.kind || !evidence.misfit.empty()) continue;
    topic.kind = *evidence.kind;
    topic.is_fixed = beginning.topics[i].name.ends_with("tf_static");
    const bool is_odometry = choice_.odometry == TopicChoice::Odometry::topic;
    if (has(choice_.scans, i)) {
      topic.use = topic.kind == MessageKind::laser    ? Use::laser
                  : topic.kind == MessageKind::echoes ? Use::echoes
                                                      : Use::cloud;
    } else if (has(choice_.ranges, i)) {
      topic.use = Use::range;
    } else if (is_odometry && choice_.odometry_topic == i) {
      topic.use = Use::odometry;
    } else if (topic.kind == MessageKind::transforms) {
      topic.use = Use::transforms;
    } else if (choice_.truth == i) {
      topic.use = Use::truth;
    } else if (has(choice_.gyros, i) || (choice_.gyro && choice_.gyro->topic == i)) {
      topic.use = Use::gyro;
      if (!choice_.gyro) gyros_[i] = {};
    }
    if (topic.use != Use::none) wanted.push_back(i);
  }
  reader_->select(wanted);
}

std::optional<MissionEvent> BagSource::next() {
  while (true) {
    if (auto event = hand_out()) return event;
    if (read_to_end_) break;
    if (const auto message = reader_->next()) {
      take(*message);
      continue;
    }
    read_to_end_ = true;
    if (auto round = ring_.finish()) {
      wait_for_round(choice_.ranges.front(), newest_log_ns_, std::move(*round));
    }
  }
  if (!std::exchange(ended_, true)) note_end();
  return std::nullopt;
}

std::optional<TransformAt> BagSource::mount_of(const Waiting& waiting) const {
  if (const auto* scan = std::get_if<LaserScanMessage>(&waiting.content)) {
    return poses_->base_from(scan->header.frame, waiting.stamp_ns);
  }
  if (const auto* cloud = std::get_if<CloudMessage>(&waiting.content)) {
    return poses_->base_from(cloud->header.frame, waiting.stamp_ns);
  }
  return TransformAt{};
}

std::optional<Transform3> BagSource::mount_of_gyro(std::size_t topic) const {
  const std::vector<std::string>& frames = evidence_[topic].frames;
  constexpr std::int64_t kEndOfTime_ns = std::numeric_limits<std::int64_t>::max();
  if (frames.empty()) return std::nullopt;
  const auto mount = poses_->base_from_frame(frames.front(), kEndOfTime_ns);
  if (!mount) return std::nullopt;
  return mount->transform;
}

bool BagSource::is_told(const Waiting& waiting, bool given_up) {
  const auto is_known = [](const std::optional<TransformAt>& at) {
    return at && at->beyond_ns == 0;
  };
  const std::optional<TransformAt> mount = mount_of(waiting);
  if (!given_up) {
    return is_known(mount) && is_known(poses_->odom_from_base(waiting.until_ns)) &&
           is_group_told(waiting);
  }
  if (mount) return true;
  const auto* scan = std::get_if<LaserScanMessage>(&waiting.content);
  refuse_laser(waiting.topic, scan != nullptr
                                  ? scan->header.frame
                                  : std::get<CloudMessage>(waiting.content).header.frame);
}

std::optional<MissionEvent> BagSource::hand_out() {
  while (true) {
    if (!truths_.empty()) {
      const TruePose truth = truths_.front();
      truths_.pop_front();
      ++info_.true_poses;
      return MissionEvent(truth);
    }
    if (waiting_.empty()) return std::nullopt;
    Waiting& front = waiting_.front();
    if (const auto* truth = std::get_if<TruePose>(&front.content)) {
      truths_.push_back(*truth);
      waiting_.pop_front();
      continue;
    }
    const bool given_up = read_to_end_ || waiting_.size() >= kMostWaiting ||
                          newest_log_ns_ - front.log_ns > kWaits_ns;
    if (!is_told(front, given_up) && !given_up) return std::nullopt;
    const Waiting waiting = std::move(front);
    waiting_.pop_front();
    std::optional<RangeReading> reading = reading_of(waiting);
    if (!reading) continue;
    note(*reading, waiting.topic);
    add_truth(waiting);
    return std::move(*reading);
  }
}

/// Nothing where odometry does not reach the reading's time.
std::optional<RangeReading> BagSource::reading_of(const Waiting& waiting) {
  auto pose = poses_->odom_from_base(waiting.stamp_ns);
  const bool has_odometry = choice_.odometry != TopicChoice::Odometry::none;
  if (!has_odometry && !pose) pose = TransformAt{};  // the gyro begins later
  if (!pose || (has_odometry && pose->beyond_ns > kNear_ns)) {
    ++without_pose_;
    return std::nullopt;
  }
  if (pose->beyond_ns > 0) ++at_nearest_pose_;
  if (std::holds_alternative<SonarRing::Round>(waiting.content)) return ring_reading(waiting);
  if (std::holds_alternative<LaserScanMessage>(waiting.content)) return laser_reading(waiting);
  RangeReading reading = cloud_reading(waiting);
  reading.timestamp_s = seconds(waiting.stamp_ns);
  reading.odom_from_robot = planar(pose->transform);
  return reading;
}

std::optional<RangeReading> BagSource::ring_reading(const Waiting& waiting) {
  if (!ring_sensor_) {
    std::vector<Transform3> mounts;
    for (const auto& [topic, frame] : ring_.sonars()) {
      const auto mount = poses_->base_from(frame, waiting.stamp_ns);
      if (!mount) {
        refuse_without_mount(
            topic, frame,
            "name the robot's frame by --base-frame, or other sonars by --range-topics");
      }
      mounts.push_back(mount->transform);
    }
    ring_sensor_ = ring_.make_sensor(mounts, options_);
  }
  RangeReading reading;
  reading.timestamp_s = seconds(waiting.stamp_ns);
  reading.odom_from_robot = planar(poses_->odom_from_base(waiting.stamp_ns)->transform);
  reading.sensor = ring_sensor_;
  reading.ranges_m = std::get<SonarRing::Round>(waiting.content).ranges_m;
  const auto nothing = static_cast<float>(ring_sensor_->max_range_m);
  for (float& range_m : reading.ranges_m) {
    if (range_m > nothing) range_m = nothing;
  }
  return reading;
}

void BagSource::note(const RangeReading& reading, std::size_t topic) {
  ++info_.readings;
  ++info_.line_counts[reader_->topics()[topic].name];
  const auto& sensors = info_.sensors;
  if (std::find(sensors.begin(), sensors.end(), reading.sensor) == sensors.end()) {
    info_.sensors.push_back(reading.sensor);
  }
  if (last_pose_) {
    info_.path_length_m += (reading.odom_from_robot.position() - last_pose_->position()).norm();
  }
  last_pose_ = reading.odom_from_robot;
  if (!info_.first_timestamp_s) info_.first_timestamp_s = reading.timestamp_s;
  info_.last_timestamp_s = reading.timestamp_s;
}

void BagSource::add_truth(const Waiting& waiting) {
  const auto truth = poses_->truth_from_base(waiting.stamp_ns);
  if (!truth || truth->beyond_ns > kNear_ns) return;
  truths_.push_back(TruePose{seconds(waiting.stamp_ns), planar(truth->transform)});
}

std::unique_ptr<MissionSource> open_recording(const std::filesystem::path& path,
                                              const MissionOptions& options) {
  if (!is_recording(path)) return nullptr;
  const std::filesystem::path name =
      path.has_filename() ? path.filename() : path.parent_path().filename();
  return std::make_unique<BagSource>(
      as_utf8(name.string()), [path] { return open_bag(path); }, options);
}

}  // namespace roomatlas::io
