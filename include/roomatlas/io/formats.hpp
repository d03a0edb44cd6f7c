// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/evaluate/evaluate.hpp"
#include "roomatlas/merge/floor_plan.hpp"
#include "roomatlas/mission/mission.hpp"
#include "roomatlas/simulate/simulate.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace roomatlas {

using Path = std::filesystem::path;

/// Opens a mission log, plain or gzip; the format is told by content, not by name. Throws
/// InputError naming the file when it is missing, empty, binary, or holds no line of a known
/// format. Reads streaming: nothing but one look-ahead is kept.
[[nodiscard]] std::unique_ptr<MissionSource> open_mission(const Path& file,
                                                          const MissionOptions& options);

/// The same with one kind of sensor (one_sensor_kind.hpp) and without jumps of odometry
/// (odometry_jumps.hpp).
[[nodiscard]] std::unique_ptr<MissionSource> open_mission_to_map(const Path& file,
                                                                 const MissionOptions& options);

/// For a mission that was read to its end. Throws NotEnoughError when it has no range reading, or
/// no odometry, because every line that should hold one was left out, which is an error among its
/// issues: says how many there are and why the first of them was left out.
void require_lines_that_could_be_read(const MissionInfo& info);

/// Relations, one `t1 t2 x y z roll pitch yaw` a line. Throws InputError naming file and line.
[[nodiscard]] std::vector<Relation> read_relations(const Path& file);

/// TUM trajectory: `timestamp tx ty tz qx qy qz qw` a line, numbers in their shortest form that
/// reads back to the same double.
void write_tum(const Path& file, const Trajectory& trajectory);
[[nodiscard]] Trajectory read_tum(const Path& file);

/// The plan as GeoJSON in local metres, and back (docs/formats.md has the attribute schema).
/// Reading throws InputError naming the feature and property at fault.
[[nodiscard]] std::string to_geojson(const FloorPlan& plan);
[[nodiscard]] FloorPlan read_plan(const Path& file);

struct WorldFileOptions {
  double resolution_m = 0.0;  ///< of a bare picture, metres a pixel; 0 where it is not known
  Path room_labels;           ///< picture with the room's number for each pixel; empty for none
};

/// A world to drive through: a plan as GeoJSON, a nav2 map (YAML, with its picture), or a bare
/// picture (PNG, PGM; also gzip) with its resolution; told by ending and content. The lower left
/// corner of a bare picture is the origin. What was assumed about a picture is in the plan's
/// issues (docs/formats.md). Throws InputError for what cannot be read, UsageError for options
/// that do not fit the file.
[[nodiscard]] FloorPlan read_world(const Path& file, const WorldFileOptions& options);

/// Way-points of a scripted drive: `x y` a line, metres, `#` starts a comment.
[[nodiscard]] Drive read_drive(const Path& file);

/// Writes a CARMEN log with PARAM, ODOM, SONAR or FLASER, and TRUEPOS lines, step by step. A laser
/// must have 181 beams from -90 to 90 degrees, since FLASER lines carry no bearings
/// (std::invalid_argument).
class CarmenWriter {
 public:
  CarmenWriter(const Path& file, const RangeSensor& sensor, const RobotFootprint& footprint);
  ~CarmenWriter();
  CarmenWriter(const CarmenWriter&) = delete;
  CarmenWriter& operator=(const CarmenWriter&) = delete;
  void write(const SimulatedStep& step);
  /// Renames the temporary file to its final name. Without it nothing is left behind.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Renders an SVG document to a PNG. Throws InputError when it cannot be written.
void write_png(const Path& file, const std::string& svg, double dots_per_inch);

/// Writes to a temporary name beside `file` and renames it.
void write_file(const Path& file, const std::string& content);

/// SHA-256 of a file's bytes, in hexadecimal.
[[nodiscard]] std::string sha256_of_file(const Path& file);

}  // namespace roomatlas
