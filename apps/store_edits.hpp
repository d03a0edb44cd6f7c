// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "commands.hpp"
#include "roomatlas/edit/edit.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"

namespace roomatlas::apps {

/// The key of a store's metadata under which its statements are kept, as edits.json.
inline constexpr const char* kEditsKey = "edits_json";

/// The statements of `--edits`, with the places of rooms that are told by number; without one
/// those that the store keeps.
[[nodiscard]] std::vector<Edit> edits_for(const Settings& settings, const GeoPackageStore& store);

[[nodiscard]] std::vector<Edit> stored_edits(const GeoPackageStore& store);

/// A statement as text to compare it by: a room that is told by its number is the same one,
/// whatever its shape is by now.
[[nodiscard]] std::string as_told(Edit edit);

/// Keeps statements for later assemblies, where there are any or were any.
void keep_edits(const std::vector<Edit>& edits, GeoPackageStore& store);

}  // namespace roomatlas::apps
