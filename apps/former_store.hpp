// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/plan/floor_plan.hpp"
#include "settings.hpp"
#include "store_metadata.hpp"

namespace roomatlas::apps {

/// What people put into a store that is about to be replaced.
struct Former {
  std::vector<PlanRoom> rooms;  ///< for their numbers and names
  Metadata edits;               ///< the entry of the statements, where it has any
};

/// Nothing where there is no store, or one of another building, which has another frame: nothing is
/// carried over then, see `replace_store`.
/// @param building that replaces it, as `building_of` tells them apart
[[nodiscard]] Former former_in(const std::filesystem::path& store, const std::string& building);

/// The building, see `building_of`, of a store in which people named or corrected something; empty
/// where there is none, or it cannot be read.
[[nodiscard]] std::string named_building_in(const std::filesystem::path& store);

/// Puts what people said into a store that is to be assembled, in the same frame: names and
/// statements of the former building, and before them those of its base mission that it does not
/// have. What is said later holds.
void put_said(const Former& former, const GeoPackageStore& base, GeoPackageStore& store);

/// @throws OtherVersion for a store that another release wrote, unless `settings.force`: what
/// people
///   put into it (names, corrections) is not carried over
void require_known_version(const Settings& settings, const std::filesystem::path& store);

}  // namespace roomatlas::apps
