// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/issue.hpp"
#include "roomatlas/core/pose2.hpp"
#include "roomatlas/evaluate/restamp.hpp"
#include "roomatlas/mission/mission.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace roomatlas {

/// What a pose's time is.
enum class PoseClock {
  timestamps,  ///< seconds
  numbers,     ///< vertex ids of a graph, or the numbers of poses, where the file has no times
};

struct TrajectoryFile {
  std::string format;  ///< "TUM", "poses", "g2o", or the mission log's format
  PoseClock clock = PoseClock::timestamps;
  Trajectory poses;  ///< in file order
  Issues issues;
};

/// Which poses of a mission log are meant.
enum class LogPoses {
  recorded,  ///< odometry's, one for each range reading
  truth,     ///< TRUEPOS where the log has them, else as recorded (corrected logs)
};

/// Reads a trajectory, told by content, plain or gzip: TUM; `timestamp x y theta` or `x y theta` a
/// line; vertices of g2o and TORO graphs (a vertex followed by a ROBOTLASER1 line has that line's
/// timestamp, where all have one, else its id); any mission log. A mission log gives robot poses. A
/// recording of topics gives, as truth, the poses of a topic or of tf (MissionOptions::recording
/// says which); else odometry at its readings, or the poses of a topic where it has no ranges.
/// Throws InputError naming file and line; also where headings look like degrees.
[[nodiscard]] TrajectoryFile read_trajectory(const std::filesystem::path& file,
                                             const MissionOptions& options, LogPoses log_poses);

/// Both clocks of each laser line of a CARMEN log: `... timestamp host logger_timestamp`. Lines
/// without both are passed over. Throws InputError when no line has them.
[[nodiscard]] std::vector<ClockReading> read_clock(const std::filesystem::path& file);

}  // namespace roomatlas
