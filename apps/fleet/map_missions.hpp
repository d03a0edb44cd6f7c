// SPDX-License-Identifier: GPL-3.0-or-later
// The missions of a fleet, each mapped by a process of its own: what ends one ends no other.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "run_locks.hpp"

namespace roomatlas::apps {

/// The missions of one run. Parallel: one log, one store.
struct FleetMissions {
  std::vector<Path> logs;
  std::vector<Path> stores;
};

/// Where a mission that failed has its reason: beside its store.
[[nodiscard]] Path failure_file(const Path& store);

/// Maps missions that no other rank has, and those whose rank died, until all are finished or have
/// failed. Each rank calls it. What is taken stays taken until the run ends.
/// @param slots missions at once on this rank
/// @param command the program and its arguments that map the i-th mission
/// @param stops asked now and then; true ends it
/// @throws Interrupted when `stops` says so
void map_missions(const FleetMissions& missions, const RunLocks& locks, int slots,
                  const std::function<std::vector<std::string>(std::size_t)>& command,
                  const std::function<bool()>& stops);

}  // namespace roomatlas::apps
