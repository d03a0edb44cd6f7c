// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "odometry_track.hpp"

#include "roomatlas/mission/mission.hpp"

#include <deque>
#include <optional>

namespace roomatlas::io {

/// Events in file order, of which some still wait for their robot pose. Holds at most `kMost`.
class EventQueue {
 public:
  static constexpr std::size_t kMost = 256;  ///< events; then a pose that never comes is given up

  /// Why an event's pose is open.
  enum class Wait {
    no_pose_on_line,
    zero_pose_on_line,  ///< all zero: filled in or not, a later line will tell
  };

  void push(MissionEvent event) { entries_.push_back({std::move(event), std::nullopt, {}}); }
  void push(RangeReading reading, const AwaitedPose& pose, Wait wait) {
    entries_.push_back({std::move(reading), pose, wait});
  }

  /// The next odometry line of the file has this pose.
  void see_odometry(const StampedPose& line);
  /// The log's scans do have poses: the zeros that wait were meant.
  void believe_zero_poses();

  [[nodiscard]] bool empty() const { return entries_.empty(); }
  /// The first event can be taken: its pose is known, or the queue is full.
  [[nodiscard]] bool ready() const {
    return !empty() && (!entries_.front().pose || entries_.size() >= kMost);
  }

  struct Taken {
    MissionEvent event;
    bool without_odometry = false;  ///< no odometry was in reach: the pose is the origin
  };
  /// Takes the first event, with the best guess where its pose is still open. Not when empty.
  [[nodiscard]] Taken take();

 private:
  struct Entry {
    MissionEvent event;
    std::optional<AwaitedPose> pose;  ///< while open
    Wait wait = Wait::no_pose_on_line;
  };
  static void settle(Entry& entry, const Pose2& odom_from_robot);

  std::deque<Entry> entries_;
};

}  // namespace roomatlas::io
