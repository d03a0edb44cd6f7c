// SPDX-License-Identifier: GPL-3.0-or-later
// Mapping goes on where a run that was stopped left it.
#pragma once

#include <optional>
#include <string>

#include "commands.hpp"
#include "roomatlas/pipeline/map_checkpoint.hpp"

namespace roomatlas::apps {

/// A store in which a mission is mapped up to some room.
struct UnfinishedStore {
  Path file;
  MapCheckpoint checkpoint;
};

/// The unfinished store of the same log, by the same version and with the same parameters of
/// mapping, in its place or beside it; the one with more rooms where there are two. Nothing where
/// there is none; what is unfinished there but made otherwise, a warning names with the reason.
[[nodiscard]] std::optional<UnfinishedStore> find_unfinished(const Settings& settings,
                                                             const std::string& mission_sha256,
                                                             const Path& named);

/// What `map` says of it.
/// @param part of the log that is mapped
[[nodiscard]] GoneOn gone_on_with(const UnfinishedStore& store, const Path& log,
                                  const MissionPart& part);

/// "going on after room 12 of an interrupted run (reading 48,120 of the log)"
[[nodiscard]] std::string to_string(const GoneOn& gone_on);

}  // namespace roomatlas::apps
