// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/frame_tree.hpp"
#include "bags/steered_odometry.hpp"
#include "bags/topic_choice.hpp"

#include <optional>
#include <string>

namespace roomatlas::io {

/// Frames that are the robot by custom, and differ in height alone.
[[nodiscard]] bool is_usual_base(const std::string& frame);

/// Where the robot was and where its sensors sit, as far as the recording has told by now.
class RobotPoses {
 public:
  /// @param mount of all lasers, where the user gave it
  RobotPoses(const TopicChoice& choice, const FrameTree& known_before,
             const std::optional<Pose2>& mount);

  void add_odometry(const PoseMessage& pose, std::int64_t stamp_ns);
  /// Of the gyro that is chosen.
  void add_turn(const ImuMessage& imu, std::int64_t stamp_ns);
  void add_transforms(const TransformsMessage& message, bool is_fixed);
  /// All of a message at one time: stamps are not believed.
  void add_transforms_at(const TransformsMessage& message, bool is_fixed, std::int64_t time_ns);

  /// The robot's odometry pose; the origin where the mission has no odometry, turned as a gyro says
  /// where one is chosen.
  [[nodiscard]] std::optional<TransformAt> odom_from_base(std::int64_t stamp_ns) const;
  /// A laser's mount: the user's, else as `base_from_frame` has it.
  [[nodiscard]] std::optional<TransformAt> base_from(const std::string& frame,
                                                     std::int64_t stamp_ns) const;
  /// A sensor's mount by tf. A frame that no transform joins to the robot's has none; `base_link`
  /// and `base_footprint`, which differ in height alone, count as one where nothing joins them.
  [[nodiscard]] std::optional<TransformAt> base_from_frame(const std::string& frame,
                                                           std::int64_t stamp_ns) const;
  /// What stands between a frame that moves with the robot and the robot's own; nothing where no
  /// transform joins them.
  [[nodiscard]] std::optional<Transform3> base_in(const std::string& frame,
                                                  std::int64_t stamp_ns) const;
  /// As tf's root frame has it, where truth is asked of tf.
  [[nodiscard]] std::optional<TransformAt> truth_from_base(std::int64_t stamp_ns) const;

  [[nodiscard]] const FrameTree& frames() const { return frames_; }
  /// Of odometry's, whose turns a gyro should have told.
  [[nodiscard]] std::int64_t steps_without_gyro() const;
  [[nodiscard]] bool took_base_frames_for_one() const { return took_for_one_; }
  [[nodiscard]] std::int64_t clock_set_back() const { return clock_set_back_; }
  [[nodiscard]] std::int64_t out_of_order() const { return out_of_order_; }
  [[nodiscard]] std::int64_t unsound() const { return unsound_ + frames_.unsound(); }

 private:
  void note(TransformTrack::Added added);
  void add_transform(const PoseMessage& transform, std::int64_t stamp_ns, bool is_fixed);
  [[nodiscard]] std::optional<TransformAt> odom_from_child(std::int64_t stamp_ns) const;

  const TopicChoice& choice_;
  FrameTree frames_;
  TransformTrack odometry_;
  std::optional<SteeredOdometry> steered_;  ///< where a gyro is chosen
  std::optional<Pose2> mount_;
  mutable bool took_for_one_ = false;
  std::int64_t clock_set_back_ = 0;
  std::int64_t out_of_order_ = 0;
  std::int64_t unsound_ = 0;
};

}  // namespace roomatlas::io
