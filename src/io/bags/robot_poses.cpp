// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/robot_poses.hpp"

#include <algorithm>
#include <array>

namespace roomatlas::io {
namespace {

constexpr std::array kBaseFrames = {"base_link", "base_footprint", "base"};

}  // namespace

bool is_usual_base(const std::string& frame) {
  return std::count(kBaseFrames.begin(), kBaseFrames.end(), frame) > 0;
}

RobotPoses::RobotPoses(const TopicChoice& choice, const FrameTree& known_before,
                       const std::optional<Pose2>& mount)
    : choice_(choice), mount_(mount) {
  frames_.add_fixed_of(known_before);
  if (choice.gyro) steered_.emplace(*choice.gyro, choice.odometry != TopicChoice::Odometry::none);
}

void RobotPoses::note(TransformTrack::Added added) {
  if (added == TransformTrack::Added::clock_set_back) ++clock_set_back_;
  if (added == TransformTrack::Added::out_of_order) ++out_of_order_;
}

void RobotPoses::add_odometry(const PoseMessage& pose, std::int64_t stamp_ns) {
  if (!pose.frame_from_child) {
    ++unsound_;
    return;
  }
  note(odometry_.add(stamp_ns, *pose.frame_from_child));
  if (steered_) steered_->add_odometry(stamp_ns, planar(*pose.frame_from_child));
}

void RobotPoses::add_turn(const ImuMessage& imu, std::int64_t stamp_ns) {
  if (steered_) steered_->add_turn(stamp_ns, imu.turn_rad_per_s);
}

void RobotPoses::add_transforms(const TransformsMessage& message, bool is_fixed) {
  for (const PoseMessage& transform : message) {
    add_transform(transform, transform.header.stamp_ns, is_fixed);
  }
}

void RobotPoses::add_transforms_at(const TransformsMessage& message, bool is_fixed,
                                   std::int64_t time_ns) {
  for (const PoseMessage& transform : message) add_transform(transform, time_ns, is_fixed);
}

/// Of tf the edge that is odometry alone is noted: others may come from several clocks.
void RobotPoses::add_transform(const PoseMessage& transform, std::int64_t stamp_ns, bool is_fixed) {
  const TransformTrack::Added added = frames_.add(transform, stamp_ns, is_fixed);
  const bool is_odometry = choice_.odometry == TopicChoice::Odometry::transforms &&
                           transform.child_frame == choice_.odometry_child;
  if (!is_odometry) return;
  note(added);
  if (steered_ && transform.frame_from_child) {
    steered_->add_odometry(stamp_ns, planar(*transform.frame_from_child));
  }
}

std::int64_t RobotPoses::steps_without_gyro() const {
  return steered_ ? steered_->steps_without_gyro() : 0;
}

std::optional<TransformAt> RobotPoses::odom_from_child(std::int64_t stamp_ns) const {
  if (steered_) return steered_->at(stamp_ns);
  if (choice_.odometry == TopicChoice::Odometry::topic) return odometry_.at(stamp_ns);
  return frames_.lookup(choice_.odometry_frame, choice_.odometry_child, stamp_ns,
                        Constant::in_its_times);
}

std::optional<TransformAt> RobotPoses::odom_from_base(std::int64_t stamp_ns) const {
  using Odometry = TopicChoice::Odometry;
  if (choice_.odometry == Odometry::none) {
    return steered_ ? steered_->at(stamp_ns) : TransformAt{};
  }
  std::optional<TransformAt> found = odom_from_child(stamp_ns);
  if (!found || choice_.odometry_child == choice_.base_frame) return found;
  const auto child_from_base =
      frames_.lookup(choice_.odometry_child, choice_.base_frame, stamp_ns, Constant::holds_always);
  if (!child_from_base) return found;  // the two are taken for one
  return TransformAt{found->transform * child_from_base->transform,
                     std::max(found->beyond_ns, child_from_base->beyond_ns)};
}

std::optional<TransformAt> RobotPoses::base_from(const std::string& frame,
                                                 std::int64_t stamp_ns) const {
  return mount_ ? TransformAt{upright(*mount_), 0} : base_from_frame(frame, stamp_ns);
}

std::optional<TransformAt> RobotPoses::base_from_frame(const std::string& frame,
                                                       std::int64_t stamp_ns) const {
  const std::string& base = choice_.base_frame;
  if (auto known = frames_.lookup(base, frame, stamp_ns, Constant::holds_always)) return known;
  if (!is_usual_base(base)) return std::nullopt;
  for (const char* other : kBaseFrames) {
    if (auto known = frames_.lookup(other, frame, stamp_ns, Constant::holds_always)) {
      took_for_one_ = true;
      return known;
    }
  }
  return std::nullopt;
}

std::optional<Transform3> RobotPoses::base_in(const std::string& frame,
                                              std::int64_t stamp_ns) const {
  if (frame == choice_.base_frame) return Transform3{};
  const auto known = frames_.lookup(frame, choice_.base_frame, stamp_ns, Constant::holds_always);
  if (!known) return std::nullopt;
  return known->transform;
}

std::optional<TransformAt> RobotPoses::truth_from_base(std::int64_t stamp_ns) const {
  if (choice_.truth_frame.empty()) return std::nullopt;
  const bool has_odometry = choice_.odometry != TopicChoice::Odometry::none;
  const std::string& below = has_odometry ? choice_.odometry_frame : choice_.base_frame;
  const auto truth_from_below = frames_.newest(choice_.truth_frame, below);
  auto pose = odom_from_base(stamp_ns);
  if (!truth_from_below || !pose) return std::nullopt;
  pose->transform = *truth_from_below * pose->transform;
  return pose;
}

}  // namespace roomatlas::io
