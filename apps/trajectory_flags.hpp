// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "roomatlas/evaluate/compare.hpp"
#include "roomatlas/io/trajectories/trajectory_file.hpp"
#include "settings.hpp"

namespace CLI {
class App;
}

namespace roomatlas::apps {

/// How trajectories are brought to the truth's times and judged. Not part of the configuration
/// that is kept in a store: a map does not depend on how it is judged.
struct TrajectoryFlags {
  CompareOptions compare;
  std::vector<double> pose_offset;  ///< x y theta; empty or three
  double time_offset_s = 0.0;
  std::filesystem::path stamps_from;
  std::filesystem::path carry;
};

void add_trajectory_flags(CLI::App* command, TrajectoryFlags& flags);

/// The flags with their files read: what makes trajectories comparable.
class Preparation {
 public:
  Preparation(const TrajectoryFlags& flags, const Settings& settings);

  /// The trajectory with the truth's clock, and of the point of the robot that the truth means.
  /// Issues go to the console.
  [[nodiscard]] Trajectory operator()(const std::string& name, Trajectory trajectory) const;
  /// Odometry that fills gaps, or null.
  [[nodiscard]] const Trajectory* carry() const { return carry_.empty() ? nullptr : &carry_; }
  [[nodiscard]] RelationOptions relation_options() const;
  /// What was done to every trajectory, one line each; empty where nothing was.
  [[nodiscard]] const std::vector<std::string>& steps() const { return steps_; }

 private:
  CompareOptions compare_;
  Pose2 pose_from_point_;
  double time_offset_s_ = 0.0;
  std::vector<ClockReading> clock_;
  Trajectory carry_;
  std::vector<std::string> steps_;
};

}  // namespace roomatlas::apps
