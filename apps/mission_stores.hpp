// SPDX-License-Identifier: GPL-3.0-or-later
// The stores of single missions from which a building is joined.
#pragma once

#include <optional>
#include <vector>

#include "commands.hpp"
#include "mission_parts.hpp"

namespace roomatlas::apps {

/// True when an earlier run left a finished map of this log, or of this part of it.
[[nodiscard]] bool is_mapped_already(const Settings& settings, const LogPart& mission,
                                     const Path& store_file);

/// @throws UsageError for a finished map, which stands alone
void require_no_map(const Path& log);

/// One mission of several in a store of its own, which an earlier run may have left.
/// @returns nothing for a part of a log that is too little to be mapped
std::optional<Mapped> map_and_assemble(const Settings& settings, const LogPart& mission,
                                       const Path& store);

/// Stores of several missions, named after their logs: NAME.gpkg, and NAME-2.gpkg where two logs
/// have one name. Parts of a log are NAME-part1.gpkg and so on. Logs that had a store keep it:
/// those of one name are read for that, and the stores there opened, so one process asks it once
/// and before any of them is written.
[[nodiscard]] std::vector<Path> stores_for(const std::vector<LogPart>& missions,
                                           const Path& folder);

}  // namespace roomatlas::apps
