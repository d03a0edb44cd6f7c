// SPDX-License-Identifier: GPL-3.0-or-later
// What the module does, as values of the library: nothing here knows of Python. Parameters come as
// TOML, a line each, by the names that the command line has.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomatlas/core/progress.hpp"
#include "roomatlas/draw/draw.hpp"
#include "roomatlas/grid/map_cells.hpp"
#include "roomatlas/io/files/path.hpp"
#include "roomatlas/plan/judgement.hpp"
#include "roomatlas/simulate/simulate.hpp"

namespace roomatlas::python {

/// A plan and what its drawing says beside it.
struct DrawnPlan {
  FloorPlan plan;
  PlanAnnotations annotations;
};

/// What a store holds, read once.
struct Building {
  DrawnPlan drawn;
  Trajectory odometry;
  Trajectory corrected;  ///< building metres, parallel to `odometry`
  std::optional<Judgement> judgement;
};

/// Maps a log or a finished map into a new store and assembles it.
/// @param former store whose rooms' numbers and names are carried over, where it is of this log
/// @param resolution_m of a bare picture, metres a pixel; 0 for all else
/// @param jobs threads; 0: one for each core
void build(const Path& input, const Path& store, const Path& former, double resolution_m,
           const std::string& parameters, int jobs, const Progress& progress);

[[nodiscard]] Building read_building(const Path& store);

/// Rooms and doors of a finished map.
[[nodiscard]] DrawnPlan segment(const MapCells& map, const std::string& parameters,
                                const Progress& progress);
[[nodiscard]] DrawnPlan segment(const Path& map, double resolution_m, const std::string& parameters,
                                const Progress& progress);

/// All figures of a store against files of truth, as one JSON object.
[[nodiscard]] std::string evaluate(const Path& store, const std::vector<Path>& truth,
                                   const std::string& parameters);

struct SimulationTask {
  Path world;
  Path out;
  std::string format;  ///< ending of the log: clf, bag, mcap, db3
  bool tour = false;   ///< through all rooms; else the robot explores, where `drive` is empty
  Drive drive;
};
/// Writes mission.FORMAT, truth.tum and truth.geojson. @returns how many readings
std::size_t simulate(const SimulationTask& task, const std::string& parameters,
                     const Progress& progress);

}  // namespace roomatlas::python
