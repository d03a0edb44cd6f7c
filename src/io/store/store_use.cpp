// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/store/store_use.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <set>
#include <string_view>
#include <thread>

#include "database.hpp"
#include "geopackage_schema.hpp"
#include "roomatlas/core/issue.hpp"

namespace roomatlas {
namespace {

constexpr int kPrimaryCode = 0xff;  // of SQLite's extended error codes
constexpr int kBusy = 5;
constexpr int kLocked = 6;

constexpr int kAttempts = 20;  // somebody may have it open for a moment, to look
constexpr std::chrono::milliseconds kBetweenAttempts{100};

bool is_in_use(const SQLite::Exception& error) {
  const int code = error.getErrorCode() & kPrimaryCode;
  return code == kBusy || code == kLocked;
}

/// Tables that a store has not from its beginning, and those that SQLite and drivers of GeoPackage
/// keep by themselves.
bool is_known(const std::string& table) {
  constexpr std::array<std::string_view, 6> kLater = {"checkpoint",        "made_from",
                                                      "missions",          "matched_path",
                                                      "gpkg_ogr_contents", "gpkg_extensions"};
  return std::find(kLater.begin(), kLater.end(), table) != kLater.end() ||
         table.starts_with("sqlite_") || table.starts_with("rtree_");
}

using Columns = std::map<std::string, std::set<std::string>>;

/// Of all tables and views.
Columns columns_in(Database& db) {
  Columns columns;
  db.for_each_row(
      "SELECT m.name, c.name FROM sqlite_master AS m, pragma_table_info(m.name) AS c "
      "WHERE m.type IN ('table', 'view')",
      [&](Row& row) {
        std::set<std::string>& of_table = columns[row.text()];
        of_table.insert(row.text());
      });
  return columns;
}

std::multiset<std::string> styles_in(Database& db) {
  std::multiset<std::string> styles;
  db.for_each_row("SELECT f_table_name, styleName, styleQML FROM layer_styles", [&](Row& row) {
    std::string style = row.text() + '\n';
    style += row.text() + '\n';
    styles.insert(style += row.text());
  });
  return styles;
}

/// Also while another only reads it in WAL mode.
bool has_other_user(const std::filesystem::path& file) {
  bool is_used = false;
  try {
    Database db(file, SQLite::OPEN_READWRITE);
    db.connection().setBusyTimeout(0);  // the attempts are spread over time already
    db.for_each_row("PRAGMA journal_mode = DELETE",
                    [&](Row& row) { is_used = row.text() == "wal"; });
    SQLite::Transaction writing(db.connection(), SQLite::TransactionBehavior::IMMEDIATE);
  } catch (const SQLite::Exception& error) {  // who reads it says what else is wrong with it
    is_used = is_used || is_in_use(error);
  } catch (const DamagedData&) {
  }
  return is_used;
}

/// What is in `db` beyond what is in a new store.
std::vector<std::string> added_to(Database& ours, Database& db) {
  const Columns known = columns_in(ours);
  std::vector<std::string> added;
  const Columns found = columns_in(db);
  for (const auto& [table, columns] : found) {
    const auto our_own = known.find(table);
    if (our_own == known.end() && !is_known(table)) added.push_back("the table " + table);
    if (our_own == known.end()) continue;
    for (const std::string& column : columns) {
      if (our_own->second.contains(column)) continue;
      added.push_back("the column " + column);
      added.back() += " of the table " + table;
    }
  }
  if (!found.contains("layer_styles")) return added;
  const std::multiset<std::string> written = styles_in(ours);
  const std::multiset<std::string> styles = styles_in(db);
  if (!std::includes(written.begin(), written.end(), styles.begin(), styles.end())) {
    added.emplace_back("the table layer_styles");
  }
  return added;
}

/// @throws InputError when the file cannot be read
template <typename Read>
auto read_from(const std::filesystem::path& file, Read read) try {
  Database db(file, SQLite::OPEN_READONLY);
  return read(db);
} catch (const SQLite::Exception& error) {
  throw InputError(file.string() + ": cannot be read: " + error.what());
} catch (const DamagedData& damage) {
  throw InputError(file.string() + ": cannot be read: " + damage.what());
}

}  // namespace

void require_no_other_user(const std::filesystem::path& file) {
  std::error_code missing;
  if (!std::filesystem::is_regular_file(file, missing)) return;
  if (std::filesystem::is_empty(file, missing)) return;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    if (!has_other_user(file)) return;
    std::this_thread::sleep_for(kBetweenAttempts);
  }
  throw InputError(file.string() +
                   ": another program has it open, and nothing was touched: close it there (in "
                   "QGIS, remove its layers) and try again");
}

bool holds_nothing(const std::filesystem::path& file) {
  std::error_code missing;
  if (std::filesystem::is_empty(file, missing)) return true;
  return read_from(file, [](Database& db) { return columns_in(db).empty(); });
}

std::vector<std::string> added_by_others(const std::filesystem::path& file) {
  Database ours(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  create_schema(ours);
  return read_from(file, [&](Database& db) { return added_to(ours, db); });
}

}  // namespace roomatlas
