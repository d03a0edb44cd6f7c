// SPDX-License-Identifier: GPL-3.0-or-later
#include "sqlite_bag.hpp"

#include "bag_file.hpp"
#include "bag_issues.hpp"
#include "rosbag2_metadata.hpp"
#include "topic_table.hpp"

#include "files/sqlite_defences.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace roomatlas::io {
namespace {

constexpr int kLargestMessage_bytes = 1 << 28;  // clouds take some 10 MB

/// A recording that was not closed has its last messages there.
bool has_write_ahead_log(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::file_size(file.string() + "-wal", error) > 0 && !error;
}

/// As SQLite's URIs want it: RFC 3986, without "?", "#" and "%" in the path.
std::string uri_of(const std::filesystem::path& file, const char* parameters) {
  constexpr const char* kHex = "0123456789ABCDEF";
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(file).string()) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = std::isalnum(byte) != 0 || c == '/' || c == '.' || c == '_' || c == '-';
    if (is_plain) {
      uri += c;
    } else {
      uri += {'%', kHex[byte >> 4], kHex[byte & 15]};
    }
  }
  return uri + parameters;
}

/// Opened so that nothing is written beside the file, in folders that are read only as well. A
/// write-ahead log is read without the index of it that other processes would share: SQLite keeps
/// that in memory where the database is its own, and is told that nobody else locks it.
std::unique_ptr<SQLite::Database> open_database(const std::filesystem::path& file, bool has_log) {
  const std::string uri = uri_of(file, has_log ? "?mode=ro&vfs=unix-none" : "?immutable=1");
  auto database = std::make_unique<SQLite::Database>(uri, SQLite::OPEN_READONLY | SQLite::OPEN_URI);
  defend(database->getHandle(), kLargestMessage_bytes);
  if (has_log) database->exec("PRAGMA locking_mode = EXCLUSIVE");
  return database;
}

bool has_table(SQLite::Database& database, const char* name) { return database.tableExists(name); }

/// Whether a file is shorter than its header says (sqlite.org/fileformat2.html, 1.3).
bool is_cut_short(const std::filesystem::path& file) {
  BagFile bag_file(file, file.string());
  const ByteSpan header = bag_file.view(0, 100);
  if (header.size() < 100) return true;
  const auto big_endian = [&](std::size_t at, std::size_t bytes) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) {
      value = value << 8 | std::to_integer<std::uint64_t>(header[at + i]);
    }
    return value;
  };
  const std::uint64_t page_bytes = big_endian(16, 2) == 1 ? 65536 : big_endian(16, 2);
  return page_bytes * big_endian(28, 4) > bag_file.size();
}

class SqliteBag final : public BagReader {
 public:
  /// Of a file that was cut short the index is not used: its pages lie between those of the rows.
  SqliteBag(std::unique_ptr<SQLite::Database> database, const std::string& name, bool is_cut)
      : database_(std::move(database)), issues_(name) {
    read_topics();
    has_time_index_ = !is_cut && find_time_index();
    if (is_cut) warn(Severity::warning, "its database was cut short: it is read as far as it goes");
    wanted_.assign(topics().size(), 1);
  }

  [[nodiscard]] const std::string& format() const override { return format_; }
  [[nodiscard]] const std::vector<BagTopic>& topics() const override { return topics_.topics(); }

  void select(const std::vector<std::size_t>& topics) override {
    std::fill(wanted_.begin(), wanted_.end(), char{0});
    for (const std::size_t topic : topics) wanted_.at(topic) = 1;
  }

  [[nodiscard]] std::optional<BagMessage> next() override {
    while (true) {
      try {
        if (!rows_ && !is_at_end_) start();
        if (is_at_end_ || !rows_->executeStep()) break;
        if (auto message = take_row()) return message;
      } catch (const SQLite::Exception& error) {
        if (!continue_behind(error)) break;
      }
    }
    is_at_end_ = true;
    return std::nullopt;
  }

  void warn(Severity severity, const std::string& what) { issues_.add(severity, what); }
  [[nodiscard]] Issues issues() const override { return issues_.list(); }
  [[nodiscard]] double progress() const override {
    if (is_at_end_) return 1.0;
    if (!rows_ || last_ <= first_) return 0.0;
    const double share = static_cast<double>(at_ - first_) / static_cast<double>(last_ - first_);
    return std::clamp(share, 0.0, 1.0);
  }

 private:
  void read_topics() {
    std::unordered_map<std::string, std::string> definitions;
    if (has_table(*database_, "message_definitions")) {
      SQLite::Statement rows(*database_,
                             "SELECT topic_type, encoded_message_definition FROM "
                             "message_definitions");
      while (rows.executeStep()) definitions[rows.getColumn(0)] = rows.getColumn(1).getString();
    }
    SQLite::Statement rows(*database_,
                           "SELECT id, name, type, serialization_format FROM topics ORDER BY id");
    while (rows.executeStep()) {
      BagTopic topic;
      topic.name = rows.getColumn(1).getString();
      const std::string type = rows.getColumn(2);
      topic.type = plain_type(type);
      topic.encoding = bag_encoding_of(rows.getColumn(3).getString());
      const auto definition = definitions.find(type);
      if (definition != definitions.end()) topic.definition = definition->second;
      if (const auto index = topics_.add(std::move(topic))) topic_of_[rows.getColumn(0)] = *index;
    }
    if (topics_.left_out() > 0) {
      issues_.add(Severity::warning,
                  "it has more than " + std::to_string(TopicTable::kMostTopics) +
                      " topics: the further ones are left out, with their messages",
                  "topics", topics_.left_out());
    }
  }

  bool find_time_index() {
    SQLite::Statement indexes(*database_, "SELECT name FROM pragma_index_list('messages')");
    while (indexes.executeStep()) {
      SQLite::Statement columns(*database_,
                                "SELECT name FROM pragma_index_info(?) WHERE seqno = 0");
      columns.bind(1, indexes.getColumn(0).getString());
      if (columns.executeStep() && columns.getColumn(0).getString() == "timestamp") return true;
    }
    return false;
  }

  std::int64_t number(const std::string& sql) {
    SQLite::Statement rows(*database_, sql);
    const std::int64_t number = rows.executeStep() ? rows.getColumn(0).getInt64() : 0;
    return std::clamp<std::int64_t>(number, 0, kLatestTime_ns);
  }

  /// Sorting without an index would hold all: rows then come as they lie.
  void start() {
    const std::string key = has_time_index_ ? "timestamp" : "rowid";
    try {
      first_ = number("SELECT min(" + key + ") FROM messages");
      last_ = number("SELECT max(" + key + ") FROM messages");
    } catch (const SQLite::Exception&) {  // met again where it matters; progress is not known then
      first_ = last_ = 0;
    }
    rows_ = std::make_unique<SQLite::Statement>(
        *database_, "SELECT topic_id, timestamp, rowid, data FROM messages" + condition() +
                        " ORDER BY " + (has_time_index_ ? "timestamp, rowid" : "rowid"));
  }

  [[nodiscard]] std::string condition() const {
    if (std::find(wanted_.begin(), wanted_.end(), 0) == wanted_.end()) return "";
    std::vector<std::int64_t> ids;
    for (const auto& [id, topic] : topic_of_) {
      if (wanted_[topic] != 0) ids.push_back(id);
    }
    std::sort(ids.begin(), ids.end());
    std::string list;
    for (const std::int64_t id : ids) list += (list.empty() ? "" : ",") + std::to_string(id);
    return " WHERE topic_id IN (" + list + ")";
  }

  std::optional<BagMessage> take_row() {
    const SQLite::Column data = rows_->getColumn(3);
    const std::int64_t time_ns =
        std::clamp<std::int64_t>(rows_->getColumn(1).getInt64(), 0, kLatestTime_ns);
    at_ = has_time_index_ ? time_ns : std::max<std::int64_t>(0, rows_->getColumn(2).getInt64());
    // Read anew behind damage: up to here they have been handed out.
    if (is_second_try_ && time_ns <= handed_out_to_ns_) return std::nullopt;
    const auto topic = topic_of_.find(rows_->getColumn(0));
    if (topic == topic_of_.end()) {
      issues_.add(Severity::warning, "messages of topics that are not described",
                  "messages left out", 1);
      return std::nullopt;
    }
    if (wanted_[topic->second] == 0) return std::nullopt;
    if (time_ns < last_time_ns_) {
      issues_.add(Severity::note, "messages come after later ones: it has no index of times",
                  "messages", 1);
    }
    last_time_ns_ = time_ns;
    ++messages_;
    return BagMessage{
        topic->second,
        time_ns,
        {static_cast<const std::byte*>(data.getBlob()), static_cast<std::size_t>(data.getBytes())}};
  }

  /// Damage met by way of the index may leave the rows themselves whole: they are read once more as
  /// they lie. False where they were.
  bool continue_behind(const SQLite::Exception& error) {
    rows_.reset();
    if (!has_time_index_) {
      issues_.add(Severity::warning,
                  std::string("its database is damaged or cut short (") + error.what() +
                      "): what is behind " + std::to_string(messages_) +
                      " messages was left out; `sqlite3 FILE .recover` may find more");
      return false;
    }
    issues_.add(Severity::warning, std::string("its database is damaged (") + error.what() +
                                       "): from there on it was read without its index");
    has_time_index_ = false;
    is_second_try_ = true;
    handed_out_to_ns_ = last_time_ns_;
    return true;
  }

  std::unique_ptr<SQLite::Database> database_;
  std::string format_ = "rosbag2 (SQLite)";
  BagIssues issues_;
  TopicTable topics_;
  std::unordered_map<std::int64_t, std::size_t> topic_of_;
  std::vector<char> wanted_;
  std::unique_ptr<SQLite::Statement> rows_;
  bool has_time_index_ = false;
  bool is_second_try_ = false;
  bool is_at_end_ = false;
  std::int64_t handed_out_to_ns_ = 0;
  std::int64_t last_time_ns_ = std::numeric_limits<std::int64_t>::min();
  std::int64_t messages_ = 0;
  // Of times, or of rows where these have no index.
  std::int64_t first_ = 0;
  std::int64_t last_ = 0;
  std::int64_t at_ = 0;
};

}  // namespace

std::unique_ptr<BagReader> open_sqlite_bag(const std::filesystem::path& file,
                                           const std::string& shown_name) {
  try {
    const bool has_log = has_write_ahead_log(file);
    auto database = open_database(file, has_log);
    const bool is_cut = is_cut_short(file);
    // Without it SQLite refuses a file that is too short. Nothing is written by it.
    if (is_cut) database->exec("PRAGMA writable_schema = ON");
    if (!has_table(*database, "topics") || !has_table(*database, "messages")) return nullptr;
    auto bag = std::make_unique<SqliteBag>(std::move(database), shown_name, is_cut);
    if (bag->topics().empty()) {
      throw InputError(shown_name + ": is a rosbag2 without topics: nothing was recorded in it");
    }
    if (has_log) {
      bag->warn(Severity::note,
                "its recording was not closed: its last messages are in the file that ends in -wal "
                "beside it, and were read from there. Keep both together");
    }
    return bag;
  } catch (const SQLite::Exception& error) {
    throw InputError(shown_name + ": is a SQLite database that cannot be read (" + error.what() +
                     "): copy it again, or `sqlite3 FILE .recover` what is in it");
  }
}

}  // namespace roomatlas::io
