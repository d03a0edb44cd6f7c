// SPDX-License-Identifier: GPL-3.0-or-later
#include "trajectory_flags.hpp"

#include <fmt/format.h>

#include "console.hpp"
#include "roomatlas/core/issue.hpp"

namespace roomatlas::apps {
Preparation::Preparation(const TrajectoryFlags& flags, const Settings& settings)
    : compare_(flags.compare), time_offset_s_(flags.time_offset_s) {
  if (flags.pose_offset.size() == 3) {
    const std::vector<double>& at = flags.pose_offset;
    if (std::abs(at[2]) > 2.0 * kPi) {
      throw UsageError("--pose-offset: theta is in radians, and " + fmt::format("{}", at[2]) +
                       " looks like degrees");
    }
    pose_from_point_ = {at[0], at[1], wrap_angle(at[2])};
    steps_.push_back(fmt::format("judged {} m ahead and {} m left of the pose, turned by {} rad",
                                 at[0], at[1], at[2]));
  }
  if (!flags.stamps_from.empty()) {
    clock_ = read_clock(flags.stamps_from);
    steps_.push_back("times of the logger replaced by the timestamps of " +
                     flags.stamps_from.filename().string());
  }
  if (!flags.carry.empty()) {
    // Relative motion is wanted of the point that is judged.
    carry_ = moved(read_trajectory(flags.carry, settings.mission, LogPoses::recorded).poses,
                   pose_from_point_);
    if (carry_.empty()) throw InputError(flags.carry.string() + ": holds no poses to carry by");
    steps_.push_back("gaps carried by " + flags.carry.filename().string());
  }
  if (time_offset_s_ != 0.0) steps_.push_back(fmt::format("times later by {} s", time_offset_s_));
}

Trajectory Preparation::operator()(const std::string& name, Trajectory trajectory) const {
  if (!clock_.empty() && !has_own_stamps(trajectory, clock_)) {
    Restamped restamped = restamp(trajectory, clock_);
    for (Issue& issue : restamped.issues) issue.file = name;
    show(restamped.issues);
    trajectory = std::move(restamped.trajectory);
  }
  if (time_offset_s_ != 0.0) trajectory = shifted(std::move(trajectory), time_offset_s_);
  return moved(std::move(trajectory), pose_from_point_);
}

RelationOptions Preparation::relation_options() const { return {compare_.split_s, compare_.match}; }

}  // namespace roomatlas::apps
