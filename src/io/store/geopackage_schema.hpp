// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace roomatlas {

inline constexpr std::int64_t kApplicationId = 0x47504B47;  ///< "GPKG"
inline constexpr int kSchemaVersion = 3;  ///< changes when an older reader would fail or err
inline constexpr std::int32_t kBuildingSrsId = 100001;  ///< the building's own frame, in metres
inline constexpr const char* kSchemaVersionKey = "schema_version";

/// Makes an empty database a GeoPackage 1.3 with all tables of the store. Not transactional.
void create_schema(Database& database);

/// Part of a transaction: the tables and columns that earlier releases of this schema version did
/// not make.
void add_later_tables(Database& database);

/// Throws InputError in one line (file, found, expected, remedy) unless the database is a store of
/// this schema version.
void check_schema(Database& database, const std::filesystem::path& file);

/// The date in gpkg_contents: the mission's, or 1970-01-01 where it has no plausible Unix time.
/// Never the present, so that bytes depend on content alone.
[[nodiscard]] std::string last_change_of(std::optional<double> first_timestamp_s);

}  // namespace roomatlas
