// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "files/bytes.hpp"
#include "roomatlas/core/pose2.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace roomatlas {

/// Of a name in bytes; longer ones are damage or harm.
constexpr std::size_t kLongestName = 1000;

/// The row that a query stands on, one column after another. A REAL that is NULL is a NaN,
/// because SQLite keeps no NaN. SQLite keeps values of any type in any column: what is of another
/// type than the format says throws DamagedData with what was found and what is expected.
class Row {
 public:
  /// @param number of the row among the query's, from 1
  Row(SQLite::Statement& statement, std::int64_t number) : statement_(statement), number_(number) {}

  std::int64_t integer();
  bool flag() { return integer() != 0; }
  double real();
  /// A REAL that must be a number, of no more than kLargest.
  double finite();
  std::string text();
  /// A text of no more than kLongestName bytes, which is drawn.
  std::string name();
  /// Valid until the query takes its next step.
  ByteView blob();
  /// Of finite numbers, in metres and radians.
  Point2 point();
  Pose2 pose();
  std::optional<std::int64_t> optional_integer();
  [[nodiscard]] bool has_more() const { return column_ < statement_.getColumnCount(); }
  /// "table rooms, row 3, field geom: ", of the field that was read last.
  [[nodiscard]] std::string place() const;

  static constexpr double kLargest = 1e8;  ///< metres, radians or square metres: beyond is damage

 private:
  /// The next column, which must be of one of two types or NULL.
  SQLite::Column next(int type, int other, const char* expected);

  SQLite::Statement& statement_;
  std::int64_t number_ = 0;
  int column_ = 0;
};

/// Binds values to a statement's question marks in order; a point takes two, a pose three.
class Binder {
 public:
  explicit Binder(SQLite::Statement& statement) : statement_(statement) {}

  void operator()(bool value) { statement_.bind(++index_, value ? 1 : 0); }
  void operator()(int value) { statement_.bind(++index_, value); }
  void operator()(std::int64_t value) { statement_.bind(++index_, value); }
  void operator()(double value) { statement_.bind(++index_, value); }
  void operator()(const char* value) { statement_.bind(++index_, value); }
  void operator()(const std::string& value) { statement_.bind(++index_, value); }
  void operator()(const Bytes& value);
  void operator()(const Point2& value);
  void operator()(const Pose2& value);
  void operator()(const std::optional<std::int64_t>& value);

 private:
  SQLite::Statement& statement_;
  int index_ = 0;
};

/// A connection that keeps its prepared statements and counts the rows that it fetches.
class Database {
 public:
  Database(const std::filesystem::path& file, int sqlite_flags);

  /// Executes SQL without parameters, one or several statements.
  void execute(const std::string& sql) { connection_.exec(sql); }

  template <typename... Values>
  void run(std::string_view sql, const Values&... values) {
    const Use use(prepared(sql));
    bind(use.statement, values...);
    use.statement.exec();
  }

  /// Calls `visit(Row&)` for each row. The same SQL must not be run again inside `visit`.
  /// Returns how many rows there were.
  template <typename Visit, typename... Values>
  std::int64_t for_each_row(std::string_view sql, Visit visit, const Values&... values) {
    const Use use(prepared(sql));
    bind(use.statement, values...);
    std::int64_t rows = 0;
    for (; use.statement.executeStep(); ++rows) {
      ++rows_fetched_;
      Row row(use.statement, rows + 1);
      try {
        visit(row);
      } catch (const DamagedData& damage) {
        throw DamagedData(row.place() + damage.what());
      }
    }
    return rows;
  }

  [[nodiscard]] std::int64_t last_inserted_id() const { return connection_.getLastInsertRowid(); }
  [[nodiscard]] std::int64_t rows_fetched() const { return rows_fetched_; }
  [[nodiscard]] SQLite::Database& connection() { return connection_; }

  /// Whether SQL can damage the file or change its schema's number. It is on from the start.
  void set_defensive(bool on);

  /// Drops the prepared statements, which would keep the file in use.
  void forget_statements() { statements_.clear(); }

 private:
  /// Gives a statement back clean, also when an exception passes: a statement left in the middle
  /// holds its read transaction open.
  struct Use {
    explicit Use(SQLite::Statement& used) : statement(used) {}
    ~Use();
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;
    SQLite::Statement& statement;
  };

  template <typename... Values>
  static void bind(SQLite::Statement& statement, const Values&... values) {
    [[maybe_unused]] Binder binder(statement);
    (binder(values), ...);
  }

  SQLite::Statement& prepared(std::string_view sql);

  SQLite::Database connection_;
  std::map<std::string, SQLite::Statement, std::less<>> statements_;
  std::int64_t rows_fetched_ = 0;
};

}  // namespace roomatlas
