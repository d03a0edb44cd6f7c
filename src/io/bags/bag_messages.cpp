// SPDX-License-Identifier: GPL-3.0-or-later
// What a recording's source does with a message.
#include "bags/bag_source.hpp"

#include <algorithm>
#include <utility>

namespace roomatlas::io {

void BagSource::take(const BagMessage& message) {
  newest_log_ns_ = std::max(newest_log_ns_, message.log_time_ns);
  if (!first_log_ns_) first_log_ns_ = message.log_time_ns;
  if (message.topic >= topics_.size()) return;
  Topic& topic = topics_[message.topic];
  if (topic.use == Use::none) return;
  if (use(topic, message)) {
    ++topic.used;
    return;
  }
  ++topic.unreadable;
  ++info_.malformed_lines;
  if (topic.why.empty()) {
    topic.why = "it has " + std::to_string(message.bytes.size()) +
                " bytes, which are too few for what is in it";
  }
}

/// False where the message is left out.
bool BagSource::use(Topic& topic, const BagMessage& message) {
  const MessageCursor in(message.bytes, reader_->topics()[message.topic].encoding);
  switch (topic.use) {
    case Use::laser:
      return use_scan(topic, message, read_laser_scan(in));
    case Use::echoes:
      return use_scan(topic, message, read_echoes(in));
    case Use::cloud:
      return use_cloud(topic, message, in);
    case Use::range:
      return use_range(topic, message, in);
    case Use::odometry:
    case Use::truth:
      return use_pose(topic, message, in);
    case Use::gyro:
      return use_gyro(topic, message, in);
    case Use::transforms:
      return use_transforms(topic, message, in);
    case Use::none:
      break;
  }
  return true;
}

std::int64_t BagSource::time_of(Topic& topic, const HeaderMessage& header, std::int64_t log_ns) {
  constexpr std::size_t kMostFrames = 64;
  if (topic.frames.size() < kMostFrames) topic.frames.insert(header.frame);
  std::int64_t stamp_ns = header.stamp_ns;
  if (choice_.use_log_times) {
    stamp_ns = log_ns;
  } else if (stamp_ns <= 0) {
    ++without_stamp_;
    stamp_ns = log_ns - choice_.log_minus_stamp_ns;
  }
  if (topic.last_stamp_ns && stamp_ns < *topic.last_stamp_ns) ++info_.steps_back_in_time;
  topic.last_stamp_ns = stamp_ns;
  return stamp_ns;
}

bool BagSource::use_scan(Topic& topic, const BagMessage& message,
                         std::optional<LaserScanMessage> scan) {
  if (!scan) return false;
  if (const std::string problem = problem_of(*scan); !problem.empty()) {
    if (topic.why.empty()) topic.why = problem;
    return false;
  }
  Waiting waiting;
  waiting.topic = message.topic;
  waiting.log_ns = message.log_time_ns;
  waiting.stamp_ns = time_of(topic, scan->header, message.log_time_ns);
  waiting.until_ns = waiting.stamp_ns + static_cast<std::int64_t>(1e9 * sweep_time_s(*scan));
  if (group_.has(message.topic)) {
    group_.add(message.topic, {waiting.stamp_ns, waiting.until_ns, std::move(*scan)});
    return true;
  }
  waiting.content = std::move(*scan);
  waiting_.push_back(std::move(waiting));
  return true;
}

bool BagSource::use_cloud(Topic& topic, const BagMessage& message, const MessageCursor& in) {
  std::optional<CloudMessage> cloud = read_cloud(in);
  if (!cloud || !cloud->has_coordinates) {
    if (cloud && topic.why.empty()) topic.why = "its points have no float fields x, y and z";
    return false;
  }
  Waiting waiting;
  waiting.topic = message.topic;
  waiting.log_ns = message.log_time_ns;
  waiting.stamp_ns = waiting.until_ns = time_of(topic, cloud->header, message.log_time_ns);
  if (!cloud->times_s.empty()) {
    const float last_s = *std::max_element(cloud->times_s.begin(), cloud->times_s.end());
    waiting.until_ns += static_cast<std::int64_t>(1e9 * std::max(0.0, static_cast<double>(last_s)));
  }
  waiting.content = std::move(*cloud);
  waiting_.push_back(std::move(waiting));
  return true;
}

void BagSource::wait_for_round(std::size_t topic, std::int64_t log_ns, SonarRing::Round round) {
  Waiting waiting;
  waiting.topic = topic;
  waiting.log_ns = log_ns;
  waiting.stamp_ns = waiting.until_ns = round.stamp_ns;
  waiting.content = std::move(round);
  waiting_.push_back(std::move(waiting));
}

bool BagSource::use_range(Topic& topic, const BagMessage& message, const MessageCursor& in) {
  const std::optional<RangeMessage> range = read_range(in);
  if (!range) return false;
  const std::int64_t stamp_ns = time_of(topic, range->header, message.log_time_ns);
  if (auto round = ring_.add(message.topic, *range, stamp_ns)) {
    wait_for_round(message.topic, message.log_time_ns, std::move(*round));
  }
  return true;
}

/// Of the robot, where what was observed is another part of it that tf joins to it.
TruePose BagSource::true_pose(const PoseMessage& pose, std::int64_t stamp_ns) {
  const Transform3& world_from_child = *pose.frame_from_child;
  const bool is_robot = pose.child_frame.empty() || pose.child_frame == choice_.base_frame;
  if (is_robot) return {seconds(stamp_ns), planar(world_from_child)};
  if (const auto child_from_base = poses_->base_in(pose.child_frame, stamp_ns)) {
    return {seconds(stamp_ns), planar(world_from_child * *child_from_base)};
  }
  unjoined_truth_ = pose.child_frame;
  return {seconds(stamp_ns), planar(world_from_child)};
}

bool BagSource::use_pose(Topic& topic, const BagMessage& message, const MessageCursor& in) {
  std::optional<PoseMessage> pose =
      topic.kind == MessageKind::pose ? read_pose(in) : read_odometry(in);
  if (!pose) return false;
  const std::int64_t stamp_ns = time_of(topic, pose->header, message.log_time_ns);
  if (topic.use == Use::odometry) {
    poses_->add_odometry(*pose, stamp_ns);
  } else if (pose->frame_from_child) {
    Waiting waiting;
    waiting.topic = message.topic;
    waiting.content = true_pose(*pose, stamp_ns);
    waiting_.push_back(std::move(waiting));
  }
  const bool is_both = topic.use == Use::odometry && choice_.truth == message.topic;
  if (is_both && pose->frame_from_child) {
    truths_.push_back(true_pose(*pose, stamp_ns));
  }
  return true;
}

bool BagSource::use_gyro(Topic& topic, const BagMessage& message, const MessageCursor& in) {
  const std::optional<ImuMessage> imu = read_imu(in);
  if (!imu || !imu->has_gyro) {
    if (imu && topic.why.empty()) topic.why = "it says that it has no gyro";
    return false;
  }
  const std::int64_t stamp_ns = time_of(topic, imu->header, message.log_time_ns);
  if (choice_.gyro) {
    poses_->add_turn(*imu, stamp_ns);
  } else {
    gyros_[message.topic].add(stamp_ns, imu->turn_rad_per_s);
  }
  return true;
}

bool BagSource::use_transforms(const Topic& topic, const BagMessage& message,
                               const MessageCursor& in) {
  const std::optional<TransformsMessage> transforms = read_transforms(in);
  if (!transforms) return false;
  if (choice_.use_log_times) {
    poses_->add_transforms_at(*transforms, topic.is_fixed, message.log_time_ns);
  } else {
    poses_->add_transforms(*transforms, topic.is_fixed);
  }
  return true;
}

}  // namespace roomatlas::io
