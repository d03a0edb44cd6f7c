// SPDX-License-Identifier: GPL-3.0-or-later
#include "database.hpp"

#include <limits>

namespace roomatlas {
namespace {

constexpr int kBusyTimeout_ms = 5000;  // another program, such as QGIS, may be reading

}  // namespace

double Row::real() {
  const SQLite::Column column = next();
  return column.isNull() ? std::numeric_limits<double>::quiet_NaN() : column.getDouble();
}

ByteView Row::blob() {
  const SQLite::Column column = next();
  const auto* bytes = static_cast<const std::uint8_t*>(column.getBlob());
  return {bytes, static_cast<std::size_t>(column.getBytes())};
}

Point2 Row::point() {
  const double x = real();
  return {x, real()};
}

Pose2 Row::pose() {
  const Point2 position = point();
  return {position.x(), position.y(), real()};
}

std::optional<std::int64_t> Row::optional_integer() {
  const SQLite::Column column = next();
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
    : connection_(file.string(), sqlite_flags, kBusyTimeout_ms) {}

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
