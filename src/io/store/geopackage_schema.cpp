// SPDX-License-Identifier: GPL-3.0-or-later
#include "geopackage_schema.hpp"

#include "former_rooms.hpp"
#include "geopackage_tables.hpp"
#include "layer_styles.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace roomatlas {
namespace {

constexpr int kGeoPackageVersion = 10300;  // 1.3.0

void register_table(Database& database, const TableContents& table) {
  const bool has_geometry = table.geometry_type != nullptr;
  database.run(
      "INSERT INTO gpkg_contents (table_name, data_type, identifier, description, last_change, "
      "srs_id) VALUES (?, ?, ?, ?, ?, ?)",
      table.name, has_geometry ? "features" : "attributes", table.name, table.description,
      last_change_of(std::nullopt),
      has_geometry ? std::optional<std::int64_t>(kBuildingSrsId) : std::nullopt);
  if (!has_geometry) return;
  database.run("INSERT INTO gpkg_geometry_columns VALUES (?, 'geom', ?, ?, 0, 0)", table.name,
               table.geometry_type, static_cast<std::int64_t>(kBuildingSrsId));
}

/// @param columns the last of them tells whether all are there
void add_columns(Database& database, const std::string& table,
                 const std::vector<std::string>& columns) {
  const std::string last = columns.back().substr(0, columns.back().find(' '));
  bool is_there = false;
  database.for_each_row("SELECT name FROM pragma_table_info('" + table + "')",
                        [&](Row& row) { is_there = row.text() == last || is_there; });
  if (is_there) return;
  const std::string add = "ALTER TABLE " + table + " ADD COLUMN ";
  for (const std::string& column : columns) {
    database.execute(std::string(add).append(column));
  }
}

/// What the file says of itself: nothing when it is a store, else what it is instead.
std::optional<std::string> why_no_store(Database& database) {
  std::int64_t application_id = 0;
  database.for_each_row("PRAGMA application_id", [&](Row& row) { application_id = row.integer(); });
  if (application_id != kApplicationId) return "an empty file or another SQLite database";
  if (!database.connection().tableExists("metadata")) return "a GeoPackage of something else";
  return std::nullopt;
}

std::string found_version(Database& database, const std::filesystem::path& file) try {
  std::string version = "none";
  database.for_each_row(
      "SELECT value FROM metadata WHERE key = ?", [&](Row& row) { version = row.text(); },
      kSchemaVersionKey);
  return version;
} catch (const DamagedData& damage) {
  throw InputError(file.string() + ": " + damage.what() +
                   ": the store is damaged; map the log again");
}

}  // namespace

void create_schema(Database& database) {
  database.execute("PRAGMA application_id = " + std::to_string(kApplicationId));
  database.execute("PRAGMA user_version = " + std::to_string(kGeoPackageVersion));
  for (const char* sql : {kGeoPackageSql, kMissionSql, kResultSql, kMatchedPathSql}) {
    database.execute(sql);
  }
  for (const char* prefix : {"", kMeasured}) {
    database.execute(shapes_sql(prefix));
    database.execute(edges_sql(prefix));
  }
  for (const TableContents& table : kTables) register_table(database, table);
  create_layer_styles(database);
  create_former_rooms(database);
  database.run("INSERT INTO metadata (key, value) VALUES (?, ?)", kSchemaVersionKey,
               std::to_string(kSchemaVersion));
}

void add_later_tables(Database& database) {
  database.execute(kMatchedPathSql);
  add_columns(database, "closures",
              {"information_xx REAL", "information_xy REAL", "information_xt REAL",
               "information_yy REAL", "information_yt REAL", "information_tt REAL"});
  add_columns(database, "furniture", {"kind TEXT"});
  for (const char* prefix : {"", kMeasured}) {
    add_columns(database, prefix + std::string("doors"),
                {"kind TEXT", "leaf_hinge_x REAL", "leaf_hinge_y REAL", "leaf_end_x REAL",
                 "leaf_end_y REAL"});
    const std::string edges = prefix + std::string("edges");
    if (database.connection().tableExists(edges)) continue;
    database.execute(edges_sql(prefix));
    for (const TableContents& table : kTables) {
      if (table.name == edges) register_table(database, table);
    }
  }
}

void check_schema(Database& database, const std::filesystem::path& file) {
  const std::string expected = std::to_string(kSchemaVersion);
  std::optional<std::string> reason;
  try {
    reason = why_no_store(database);
  } catch (const SQLite::Exception& error) {
    reason = error.what();
  }
  if (reason) {
    throw InputError(file.string() + ": not a building store: found " + *reason +
                     ", expected a GeoPackage written by 'roomatlas map' or 'roomatlas build'");
  }
  const std::string found = found_version(database, file);
  if (found == expected) return;
  throw OtherVersion(file.string() + ": schema version " + found + " found, " + expected +
                     " expected: map the log again with this release, or use the release that "
                     "wrote the file");
}

std::string last_change_of(std::optional<double> first_timestamp_s) {
  constexpr double kYear1980_s = 315532800.0;  // earlier numbers count readings or uptime
  constexpr double kYear2100_s = 4102444800.0;
  const double time_s = first_timestamp_s.value_or(0.0);
  const bool plausible = time_s >= kYear1980_s && time_s < kYear2100_s;
  using namespace std::chrono;
  const sys_time<milliseconds> time{
      milliseconds(plausible ? static_cast<std::int64_t>(std::floor(time_s * 1e3)) : 0)};
  const sys_days day = floor<days>(time);
  const year_month_day date(day);
  const hh_mm_ss clock(time - day);
  char text[64];
  std::snprintf(text, sizeof text, "%04d-%02u-%02uT%02d:%02d:%02d.%03dZ", int(date.year()),
                unsigned(date.month()), unsigned(date.day()), int(clock.hours().count()),
                int(clock.minutes().count()), int(clock.seconds().count()),
                int(clock.subseconds().count()));
  return text;
}

}  // namespace roomatlas
