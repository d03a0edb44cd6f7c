// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "commands.hpp"
#include "roomatlas/match/kidnapping.hpp"

namespace roomatlas::apps {

/// A log, or what of it lies between two kidnappings.
struct LogPart {
  Path log;
  MissionPart part;
};

/// What a mission is cut into: itself where the robot was not carried away.
[[nodiscard]] std::vector<MissionPart> parts_between(const std::vector<Kidnapping>& kidnappings);

/// Where the robot of a mission was carried away, by its lasers, as far as the settings ask for it.
/// Tells of each. Reads the mission to its end.
[[nodiscard]] std::vector<Kidnapping> kidnappings_in(const Settings& settings,
                                                     MissionSource& mission);

/// The logs' parts, in the logs' order.
[[nodiscard]] std::vector<LogPart> parts_of(const Settings& settings,
                                            const std::vector<Path>& logs);

}  // namespace roomatlas::apps
