// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/mission/mission.hpp"

#include <filesystem>
#include <string>

namespace roomatlas::io {

/// Poses of one topic of a recording, or of tf.
struct RecordedPoses {
  std::string source;  ///< "/amcl_pose of ROS 1 bag 2.0"; empty: none was found
  Trajectory poses;    ///< by their headers' stamps, in file order
  Issues issues;
};

/// A recording's poses to compare with: those of `truth_topic`; where it is empty, of a topic that
/// is named for truth, else tf's robot in a frame above odometry's (what AMCL found), else of a
/// topic of poses. Throws InputError where it has none of these.
[[nodiscard]] RecordedPoses read_recorded_truth(const std::filesystem::path& path,
                                                const RecordingOptions& options);

/// What is judged in a recording without ranges: the poses of `odometry_topic`; where it is empty
/// of odometry, else of a topic of poses. Throws InputError where there are none.
[[nodiscard]] RecordedPoses read_recorded_poses(const std::filesystem::path& path,
                                                const RecordingOptions& options);

/// Whether `path` is a recording, and whether it has ranges, without which it is no mission.
[[nodiscard]] bool is_recording(const std::filesystem::path& path);
[[nodiscard]] bool has_ranges(const std::filesystem::path& path);

}  // namespace roomatlas::io
