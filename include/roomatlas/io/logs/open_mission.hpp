// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "roomatlas/io/files/path.hpp"
#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

/// Opens a mission log, plain or gzip, or a recording of topics: a ROS 1 bag, an MCAP file, a
/// rosbag2's file or folder. The format is told by content, not by name. Throws InputError naming
/// the file when it is missing, empty, binary, or holds no line of a known format; for a recording
/// also NotEnoughError when no topic of it can be mapped, and UsageError when an option names a
/// topic that it has not. Reads streaming: nothing but a bounded look-ahead is kept.
[[nodiscard]] std::unique_ptr<MissionSource> open_mission(const Path& file,
                                                          const MissionOptions& options);

/// The same with one kind of sensor (one_sensor_kind.hpp) and without jumps of odometry
/// (odometry_jumps.hpp).
[[nodiscard]] std::unique_ptr<MissionSource> open_mission_to_map(const Path& file,
                                                                 const MissionOptions& options);

/// Whether it is a recording of topics, told by its content; false for what cannot be read.
[[nodiscard]] bool is_recording(const Path& file);

/// For a mission that was read to its end. Throws NotEnoughError when it has no range reading, or
/// no odometry, because every line that should hold one was left out, which is an error among its
/// issues: says how many there are and why the first of them was left out.
void require_lines_that_could_be_read(const MissionInfo& info);

}  // namespace roomatlas
