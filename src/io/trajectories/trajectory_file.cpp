// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/trajectories/trajectory_file.hpp"
#include "roomatlas/io/files/input_file.hpp"

#include "bags/recorded_poses.hpp"
#include "logs/carmen_message.hpp"
#include "pose_rows.hpp"
#include "text/line_reader.hpp"
#include "text/numbers.hpp"
#include "text/tokens.hpp"

#include "roomatlas/io/logs/open_mission.hpp"
#include "roomatlas/io/trajectories/tum.hpp"

#include <variant>

namespace roomatlas {
namespace {

enum class Kind { tum, stamped_rows, rows, graph, log };

/// By the first line that is no comment.
Kind kind_of(const Path& file) {
  io::LineReader reader(file);
  while (const auto line = reader.next()) {
    const std::string_view text = line->substr(0, line->find('#'));
    io::Tokens fields(text);
    if (fields.at_end()) continue;
    const std::string_view first = io::Tokens(text).next();
    if (first.starts_with("VERTEX") || first.starts_with("EDGE")) return Kind::graph;
    if (!io::parse_number(first)) return Kind::log;
    switch (fields.count()) {
      case 8:
        return Kind::tum;
      case 4:
        return Kind::stamped_rows;
      case 3:
        return Kind::rows;
      default:
        return Kind::log;
    }
  }
  return Kind::log;
}

TrajectoryFile read_log(const Path& file, const MissionOptions& options, LogPoses log_poses) {
  const auto source = open_mission(file, options);
  TrajectoryFile read;
  Trajectory truth;
  while (auto event = source->next()) {
    if (const auto* reading = std::get_if<RangeReading>(&*event)) {
      read.poses.push_back({reading->timestamp_s, reading->odom_from_robot});
    } else if (const auto* pose = std::get_if<TruePose>(&*event)) {
      truth.push_back({pose->timestamp_s, pose->world_from_robot});
    }
  }
  const MissionInfo& info = source->info();
  read.format = info.format;
  read.clock = info.has_times ? PoseClock::timestamps : PoseClock::numbers;
  read.issues = info.issues;
  if (log_poses == LogPoses::truth && !truth.empty()) read.poses = std::move(truth);
  return read;
}

/// A recording of topics. One with ranges gives, as what is judged, a pose for each reading.
TrajectoryFile read_recording(const Path& path, const MissionOptions& options, LogPoses log_poses) {
  const bool is_truth = log_poses == LogPoses::truth;
  if (!is_truth && io::has_ranges(path)) return read_log(path, options, log_poses);
  io::RecordedPoses read = is_truth ? io::read_recorded_truth(path, options.recording)
                                    : io::read_recorded_poses(path, options.recording);
  return {std::move(read.source), PoseClock::timestamps, std::move(read.poses),
          std::move(read.issues)};
}

/// The last three fields, where the last and the third last are numbers.
std::optional<ClockReading> clocks_on(io::Tokens fields) {
  std::string_view last[3];
  while (!fields.at_end()) {
    last[0] = last[1];
    last[1] = last[2];
    last[2] = fields.next();
  }
  const auto timestamp_s = io::parse_number(last[0]);
  const auto logger_s = io::parse_number(last[2]);
  if (!timestamp_s || !logger_s || io::parse_number(last[1])) return std::nullopt;
  return ClockReading{*logger_s, *timestamp_s};
}

}  // namespace

TrajectoryFile read_trajectory(const Path& file, const MissionOptions& options,
                               LogPoses log_poses) {
  require_regular_file(file);
  if (io::is_recording(file)) return read_recording(file, options, log_poses);
  switch (kind_of(file)) {
    case Kind::tum:
      return {"TUM", PoseClock::timestamps, read_tum(file), {}};
    case Kind::stamped_rows:
      return io::read_pose_rows(file, true);
    case Kind::rows:
      return io::read_pose_rows(file, false);
    case Kind::graph:
      return io::read_vertices(file);
    case Kind::log:
      break;
  }
  return read_log(file, options, log_poses);
}

std::vector<ClockReading> read_clock(const Path& file) {
  io::LineReader reader(file);
  std::vector<ClockReading> clock;
  while (const auto line = reader.next()) {
    io::Tokens fields(*line);
    const io::CarmenTag* tag = io::find_carmen_tag(fields.next());
    if (tag == nullptr || tag->kind != io::CarmenKind::laser) continue;
    if (const auto reading = clocks_on(fields)) clock.push_back(*reading);
  }
  if (clock.empty()) {
    throw InputError(file.string() +
                     ": no laser line ends with `timestamp host logger_timestamp`, so it has no "
                     "stamps to give; name the CARMEN log that the poses were made from");
  }
  return clock;
}

}  // namespace roomatlas
