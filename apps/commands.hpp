// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "comparison_report.hpp"
#include "export_options.hpp"
#include "roomatlas/io/maps/read_world.hpp"
#include "roomatlas/mission/part_of_mission.hpp"
#include "roomatlas/solve/optimize.hpp"
#include "settings.hpp"
#include "trajectory_flags.hpp"

namespace roomatlas::apps {

using Path = std::filesystem::path;

/// Files and choices of `simulate`.
struct SimulateArguments {
  Path world;
  WorldFileOptions file;                      ///< of a world that is a picture
  Path drive;                                 ///< empty: the robot explores
  bool tour = false;                          ///< through all rooms, instead of a drive
  std::vector<double> start;                  ///< x and y in metres, heading in degrees; or empty
  double carry_at_s = 0.0;                    ///< then the robot is carried away; 0: it is not
  std::vector<double> carry_to;               ///< as `start`: where to; or empty
  std::optional<std::uint64_t> furnish;       ///< seed of the furniture that is put in
  std::optional<std::int64_t> random_rooms;   ///< instead of a world
  std::optional<std::uint64_t> random_world;  ///< seed of a world, instead of one
  std::string world_kind;                     ///< of it; empty: the seed chooses
  int world_rooms = 0;                        ///< of it; 0: the seed chooses
  std::string format = "clf";                 ///< of the mission: the end of its file's name
  Path out;
};

/// Files and choices of `build`.
struct BuildArguments {
  std::vector<Path> inputs;   ///< mission logs, or one finished map
  double resolution_m = 0.0;  ///< of a map that is a bare picture, a pixel; 0: not given
  Path out;
  std::vector<Path> truth;
  TrajectoryFlags trajectory;
  ExportOptions exported;
  bool strict = false;  ///< a doubtful map ends with exit code 5
};

/// Files and choices of `compare`.
struct CompareArguments {
  Path before;                       ///< store of the older mission
  Path after;                        ///< and of the newer one
  std::vector<double> old_from_new;  ///< x and y in metres, heading in degrees; or empty
  Path out;
};

/// Files and choices of `locate`.
struct LocateArguments {
  Path building;
  Path log;
  double from_s = -std::numeric_limits<double>::infinity();  ///< times as in the log
  double to_s = std::numeric_limits<double>::infinity();
  Path out;  ///< TUM; empty: not wanted
};

/// Where a run went on that another had been stopped in.
struct GoneOn {
  std::string mission;          ///< the log's name, and which part of it
  std::int64_t after_room = 0;  ///< the last one that was whole
  std::int64_t reading = 0;     ///< of the log, from 1, that had been mapped by then
};

/// What became of a mission that was to be mapped.
struct Mapped {
  std::optional<GoneOn> gone_on;  ///< nothing where it was mapped from its begin
};

// Each command reads, makes one call of the library, writes and reports. They throw what the
// library throws; `main` turns that into an exit code.

void info(const Settings& settings, const Path& log);
void build(const Settings& settings, const BuildArguments& arguments);
/// Goes on where a run of the same was stopped, unless `settings.force`.
/// @param part of the log that is mapped
Mapped map(const Settings& settings, const Path& log, const Path& store,
           const MissionPart& part = {});
/// The same, and says on stdout what was mapped where JSON is asked for.
void map_and_tell(const Settings& settings, const Path& log, const Path& store);
/// Writes what would be mapped as another log.
void convert(const Settings& settings, const Path& log, const Path& out);
/// Completes the store. @returns how many rooms the plan has
std::size_t assemble(const Settings& settings, const Path& store);
/// The same with what the store was mapped with, where this run was given nothing else.
/// @param alternative which of several answers, from 1
/// @param missions of a store of several: those that are drawn; empty: all
std::size_t assemble_again(const Settings& settings, const Path& store, int alternative,
                           const std::vector<std::string>& missions);
/// Called once all is written. Throws NotEnoughError for a plan without any room.
void require_a_room(std::size_t rooms, const Path& store);
/// @returns the names of the files that were written into the folder
std::vector<std::string> export_all(const Settings& settings, const Path& store,
                                    const std::vector<std::string>& formats,
                                    const ExportOptions& options, const Path& out);
/// The same while no other run may write into the folder, and says what was written.
void export_and_tell(const Settings& settings, const Path& store,
                     const std::vector<std::string>& formats, const ExportOptions& options,
                     const Path& out);
void evaluate(const Settings& settings, const std::vector<Path>& files,
              const std::vector<Path>& truth_files, const TrajectoryFlags& flags,
              const ComparisonFiles& results);
/// What changed between two missions in one building.
void compare(const Settings& settings, const CompareArguments& arguments);
/// The report page as one file.
void report(const Settings& settings, const Path& store, const std::vector<Path>& truth,
            const TrajectoryFlags& flags, const Path& out);
void write_report(const Settings& settings, const Path& store, const Evaluation& evaluation,
                  const Path& out);
/// Missions of one building, each in a store of its own, become one store.
void join(const Settings& settings, const std::vector<Path>& stores, const Path& out);
/// Where the robot of a log was in a building.
void locate(const Settings& settings, const LocateArguments& arguments);
void rename(const Settings& settings, const Path& store, const std::string& room,
            const std::string& name);
void inspect(const Settings& settings, const Path& store, AsrId id, const Path& out);
void simulate(const Settings& settings, const SimulateArguments& arguments);
void simulate_rooms(const Settings& settings, std::int64_t rooms, const Path& out);

/// A result was written, but with --strict its quality is not enough (exit code 5).
struct GateFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct OptimizeArguments {
  Path graph;
  Path out;
  Path covariance;  ///< empty: not wanted
  OptimizeOptions options;
  bool strict = false;
};
void optimize(const Settings& settings, const OptimizeArguments& arguments);

/// The formats that `export` writes where none is asked for.
[[nodiscard]] std::vector<std::string> export_formats();

}  // namespace roomatlas::apps
