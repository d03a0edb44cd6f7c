// SPDX-License-Identifier: GPL-3.0-or-later
#include "database.hpp"

#include "files/sqlite_defences.hpp"

#include <sqlite3.h>

#include <cmath>
#include <limits>

namespace roomatlas {
namespace {

constexpr int kLargestValue_bytes = 500'000'000;  // a room's readings take less
constexpr int kBusyTimeout_ms = 5000;             // another program, such as QGIS, may be reading

const char* type_name(int type) {
  switch (type) {
    case SQLITE_INTEGER:
      return "a whole number";
    case SQLITE_FLOAT:
      return "a number";
    case SQLITE_TEXT:
      return "text";
    case SQLITE_BLOB:
      return "bytes";
    default:
      return "nothing";
  }
}

/// The table of a query of one table.
std::string table_of(const std::string& sql) {
  constexpr std::string_view kFrom = "FROM ";
  const std::size_t at = sql.find(kFrom);
  if (at == std::string::npos) return "";
  const std::size_t begin = at + kFrom.size();
  return sql.substr(begin, sql.find_first_of(" (;", begin) - begin);
}

}  // namespace

SQLite::Column Row::next(int type, int other, const char* expected) {
  if (!has_more()) {
    throw DamagedData(std::string("the table has too few columns, expected ") + expected);
  }
  SQLite::Column column = statement_.getColumn(column_++);
  const int found = column.getType();
  if (found == type || found == other || found == SQLITE_NULL) return column;
  throw DamagedData(std::string("found ") + type_name(found) + ", expected " + expected);
}

std::string Row::place() const {
  std::string place;
  if (const std::string table = table_of(statement_.getQuery()); !table.empty()) {
    place = "table " + table + ", ";
  }
  place += "row " + std::to_string(number_);
  if (column_ > 0) place += std::string(", field ") + statement_.getColumnName(column_ - 1);
  return place + ": ";
}

std::int64_t Row::integer() {
  return next(SQLITE_INTEGER, SQLITE_INTEGER, "a whole number").getInt64();
}

double Row::real() {
  const SQLite::Column column = next(SQLITE_FLOAT, SQLITE_INTEGER, "a number");
  return column.isNull() ? std::numeric_limits<double>::quiet_NaN() : column.getDouble();
}

double Row::finite() {
  const double value = real();
  if (std::abs(value) <= kLargest) return value;
  throw DamagedData("found " +
                    (std::isnan(value) ? std::string("nothing") : std::to_string(value)) +
                    ", expected a number of no more than 100 million");
}

std::string Row::name() {
  std::string found = text();
  if (found.size() <= kLongestName) return found;
  throw DamagedData("found a name of " + std::to_string(found.size()) +
                    " bytes, expected at most " + std::to_string(kLongestName));
}

std::string Row::text() { return next(SQLITE_TEXT, SQLITE_TEXT, "text").getString(); }

ByteView Row::blob() {
  const SQLite::Column column = next(SQLITE_BLOB, SQLITE_BLOB, "bytes");
  const auto* bytes = static_cast<const std::uint8_t*>(column.getBlob());
  return {bytes, static_cast<std::size_t>(column.getBytes())};
}

Point2 Row::point() {
  const double x = finite();
  return {x, finite()};
}

Pose2 Row::pose() {
  const Point2 position = point();
  return {position.x(), position.y(), finite()};
}

std::optional<std::int64_t> Row::optional_integer() {
  const SQLite::Column column = next(SQLITE_INTEGER, SQLITE_INTEGER, "a whole number");
  if (column.isNull()) return std::nullopt;
  return column.getInt64();
}

void Binder::operator()(const Bytes& value) {
  statement_.bindNoCopy(++index_, value.data(), static_cast<int>(value.size()));
}

void Binder::operator()(const Point2& value) {
  (*this)(value.x());
  (*this)(value.y());
}

void Binder::operator()(const Pose2& value) {
  (*this)(value.position());
  (*this)(value.theta_rad);
}

void Binder::operator()(const std::optional<std::int64_t>& value) {
  if (value) return (*this)(*value);
  statement_.bind(++index_);
}

Database::Database(const std::filesystem::path& file, int sqlite_flags)
    : connection_(file.string(), sqlite_flags, kBusyTimeout_ms) {
  io::defend(connection_.getHandle(), kLargestValue_bytes);
  set_defensive(true);
  execute("PRAGMA cell_size_check = ON");
}

void Database::set_defensive(bool on) {
  sqlite3_db_config(connection_.getHandle(), SQLITE_DBCONFIG_DEFENSIVE, on ? 1 : 0, nullptr);
}

Database::Use::~Use() {
  statement.tryReset();
  try {
    statement.clearBindings();
  } catch (const SQLite::Exception&) {  // cannot fail; a destructor must not throw
  }
}

SQLite::Statement& Database::prepared(std::string_view sql) {
  const auto found = statements_.find(sql);
  if (found != statements_.end()) return found->second;
  std::string key(sql);
  SQLite::Statement statement(connection_, key);
  return statements_.emplace(std::move(key), std::move(statement)).first->second;
}

}  // namespace roomatlas
