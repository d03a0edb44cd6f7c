// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "roomatlas/plan/floor_plan.hpp"
#include "settings.hpp"
#include "store_metadata.hpp"

namespace roomatlas::apps {

/// What people put into a store that is about to be replaced.
struct Former {
  std::vector<PlanRoom> rooms;  ///< for their numbers and names
  Metadata edits;               ///< the entry of the statements, where it has any
};

/// Nothing where there is no store. A store of another building has another frame: nothing is
/// carried over, and warnings name what is lost.
/// @param building that replaces it, as `building_of` tells them apart
[[nodiscard]] Former former_in(const std::filesystem::path& store, const std::string& building);

/// Rooms with their numbers; those that nobody named get the names of rooms of another plan in the
/// same frame.
[[nodiscard]] std::vector<PlanRoom> with_names_of(std::vector<PlanRoom> rooms,
                                                  const std::vector<PlanRoom>& others);

/// @throws OtherVersion for a store that another release wrote, unless `settings.force`: what
/// people
///   put into it (names, corrections) would be lost
void require_known_version(const Settings& settings, const std::filesystem::path& store);

}  // namespace roomatlas::apps
