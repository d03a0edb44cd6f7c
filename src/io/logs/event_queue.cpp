// SPDX-License-Identifier: GPL-3.0-or-later
#include "event_queue.hpp"

#include <utility>
#include <variant>

namespace roomatlas::io {

void EventQueue::settle(Entry& entry, const Pose2& odom_from_robot) {
  std::get<RangeReading>(entry.event).odom_from_robot = odom_from_robot;
  entry.pose.reset();
}

void EventQueue::see_odometry(const StampedPose& line) {
  for (Entry& entry : entries_) {
    if (!entry.pose) continue;
    if (const std::optional<Pose2> pose = entry.pose->see(line)) settle(entry, *pose);
  }
}

void EventQueue::believe_zero_poses() {
  for (Entry& entry : entries_) {
    if (entry.pose && entry.wait == Wait::zero_pose_on_line) settle(entry, Pose2{});
  }
}

EventQueue::Taken EventQueue::take() {
  Entry& front = entries_.front();
  Taken taken;
  if (front.pose) {
    const std::optional<Pose2> guess = front.pose->give_up();
    taken.without_odometry = !guess;
    settle(front, guess.value_or(Pose2{}));
  }
  taken.event = std::move(front.event);
  entries_.pop_front();
  return taken;
}

}  // namespace roomatlas::io
