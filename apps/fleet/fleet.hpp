// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "commands.hpp"

namespace roomatlas::apps {

/// Files of a fleet's run.
struct FleetArguments {
  std::vector<Path> logs;
  Path
      out;  ///< the building's store; those of the missions go into the folder `missions` beside it
  /// The program and its arguments that map one mission of these into its store, with so many
  /// threads.
  std::function<std::vector<std::string>(std::size_t mission, const Path& store, int jobs)> command;
};

/// What one process of one mission does; it knows nothing of MPI, and of no other mission.
void map_mission_of_fleet(const Settings& settings, const Path& log, const Path& store);

struct FleetOutcome {
  int exit_code = 0;  ///< of the leader; 0 in all others
  bool has_lost_ranks = false;
};

/// What each rank does, between MPI_Init and MPI_Finalize: its share of the missions, then its
/// share of the matching; the leader writes the building.
[[nodiscard]] FleetOutcome run_fleet(const Settings& settings, const FleetArguments& arguments);

}  // namespace roomatlas::apps
