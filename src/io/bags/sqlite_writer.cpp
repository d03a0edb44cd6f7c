// SPDX-License-Identifier: GPL-3.0-or-later
#include "bag_writers.hpp"
#include "files/output_file.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace roomatlas::io {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kRowsOfATransaction = 4096;

/// "sensor_msgs/msg/LaserScan", as ROS 2 has it.
std::string ros2_type(std::string type) {
  const std::size_t slash = type.find('/');
  if (slash != std::string::npos && type.find('/', slash + 1) == std::string::npos) {
    type.insert(slash, "/msg");
  }
  return type;
}

struct Written {
  std::vector<BagTopic> topics;  ///< with their counts
  std::int64_t messages = 0;
  std::int64_t start_ns = std::numeric_limits<std::int64_t>::max();
  std::int64_t end_ns = 0;
};

class SqliteWriter final : public BagWriter {
 public:
  explicit SqliteWriter(fs::path file)
      : file_(std::move(file)), temporary_(file_.string() + ".part") {
    guarded([&] {
      { const OutputFile refused(file_); }  // says what is not to be replaced, and why
      fs::remove(temporary_);
      database_ = std::make_unique<SQLite::Database>(temporary_.string(),
                                                     SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
      database_->exec(
          "PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF;"
          "CREATE TABLE schema(schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL);"
          "INSERT INTO schema VALUES (3, 'unknown');"
          "CREATE TABLE metadata(id INTEGER PRIMARY KEY, metadata_version INTEGER NOT NULL, "
          "metadata TEXT NOT NULL);"
          "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
          "serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);"
          "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, "
          "timestamp INTEGER NOT NULL, data BLOB NOT NULL);"
          "CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL, "
          "encoding TEXT NOT NULL, encoded_message_definition TEXT NOT NULL, "
          "type_description_hash TEXT NOT NULL);"
          "CREATE INDEX timestamp_idx ON messages (timestamp ASC);"
          "BEGIN");
      insert_ = std::make_unique<SQLite::Statement>(
          *database_, "INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)");
    });
  }
  ~SqliteWriter() override {
    if (!database_) return;
    insert_.reset();
    database_.reset();
    std::error_code ignored;
    fs::remove(temporary_, ignored);
  }
  SqliteWriter(const SqliteWriter&) = delete;
  SqliteWriter& operator=(const SqliteWriter&) = delete;

  [[nodiscard]] bool takes(BagEncoding encoding) const override {
    return encoding == BagEncoding::cdr;
  }

  std::size_t add_topic(const BagTopic& topic) override {
    if (!takes(topic.encoding)) throw std::invalid_argument("a rosbag2 holds CDR messages alone");
    guarded([&] {
      SQLite::Statement insert(*database_, "INSERT INTO topics VALUES (?, ?, ?, 'cdr', '')");
      insert.bind(1, static_cast<std::int64_t>(written_.topics.size() + 1));
      insert.bind(2, topic.name);
      insert.bind(3, ros2_type(topic.type));
      insert.exec();
      if (!topic.definition.empty()) define(topic);
    });
    written_.topics.push_back(topic);
    written_.topics.back().messages = 0;
    return written_.topics.size() - 1;
  }

  void write(std::size_t topic, std::int64_t log_time_ns,
             std::span<const std::byte> bytes) override {
    guarded([&] {
      insert_->bind(1, static_cast<std::int64_t>(topic + 1));
      insert_->bind(2, log_time_ns);
      insert_->bindNoCopy(3, bytes.data(), static_cast<int>(bytes.size()));
      insert_->exec();
      insert_->reset();
    });
    ++*written_.topics.at(topic).messages;
    written_.start_ns = std::min(written_.start_ns, log_time_ns);
    written_.end_ns = std::max(written_.end_ns, log_time_ns);
    if (++written_.messages % kRowsOfATransaction == 0) {
      guarded([&] { database_->exec("COMMIT; BEGIN"); });
    }
  }

  void finish() override {
    guarded([&] {
      insert_.reset();
      database_->exec("COMMIT");
      database_.reset();
      fs::rename(temporary_, file_);
    });
  }

  [[nodiscard]] const Written& written() const { return written_; }

 private:
  void define(const BagTopic& topic) {
    const std::string type = ros2_type(topic.type);
    for (const BagTopic& known : written_.topics) {
      if (known.type == topic.type && !known.definition.empty()) return;
    }
    SQLite::Statement insert(*database_,
                             "INSERT INTO message_definitions(topic_type, encoding, "
                             "encoded_message_definition, type_description_hash) VALUES (?, "
                             "'ros2msg', ?, '')");
    insert.bind(1, type);
    insert.bind(2, topic.definition);
    insert.exec();
  }

  template <typename Work>
  void guarded(Work work) const {
    try {
      work();
    } catch (const SQLite::Exception& error) {
      fail(error.what());
    } catch (const fs::filesystem_error& error) {
      fail(error.code().message());
    }
  }
  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(file_.string() + ": cannot be written: " + reason +
                     "; check the folder, its permissions and the free space");
  }

  fs::path file_;
  fs::path temporary_;
  std::unique_ptr<SQLite::Database> database_;
  std::unique_ptr<SQLite::Statement> insert_;
  Written written_;
};

/// Version 5, which all releases since Humble read.
std::string metadata_text(const Written& written, const std::string& file_name) {
  const std::int64_t start_ns = written.messages > 0 ? written.start_ns : 0;
  const std::string duration = std::to_string(written.messages > 0 ? written.end_ns - start_ns : 0);
  std::string text =
      "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: sqlite3\n"
      "  duration:\n    nanoseconds: " +
      duration +
      "\n  starting_time:\n"
      "    nanoseconds_since_epoch: " +
      std::to_string(start_ns) + "\n  message_count: " + std::to_string(written.messages) +
      "\n  topics_with_message_count:\n";
  for (const BagTopic& topic : written.topics) {
    text += "    - topic_metadata:\n        name: " + topic.name +
            "\n        type: " + ros2_type(topic.type) +
            "\n        serialization_format: cdr\n        offered_qos_profiles: \"\"\n"
            "      message_count: " +
            std::to_string(topic.messages.value_or(0)) + "\n";
  }
  return text +
         "  compression_format: \"\"\n  compression_mode: \"\"\n  relative_file_paths:\n    - " +
         file_name + "\n  files:\n    - path: " + file_name +
         "\n      starting_time:\n        nanoseconds_since_epoch: " + std::to_string(start_ns) +
         "\n      duration:\n        nanoseconds: " + duration +
         "\n      message_count: " + std::to_string(written.messages) + "\n";
}

fs::path made(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(folder.string() + ": cannot be made: " + error.message());
  return folder;
}

class FolderWriter final : public BagWriter {
 public:
  explicit FolderWriter(const fs::path& folder)
      : folder_(made(folder)),
        file_name_(fs::absolute(folder / "x").parent_path().lexically_normal().filename().string() +
                   "_0.db3"),
        database_(folder_ / file_name_) {}

  [[nodiscard]] bool takes(BagEncoding encoding) const override {
    return database_.takes(encoding);
  }
  std::size_t add_topic(const BagTopic& topic) override { return database_.add_topic(topic); }
  void write(std::size_t topic, std::int64_t log_time_ns,
             std::span<const std::byte> bytes) override {
    database_.write(topic, log_time_ns, bytes);
  }
  void finish() override {
    database_.finish();
    OutputFile metadata(folder_ / "metadata.yaml");
    metadata.write(metadata_text(database_.written(), file_name_));
    metadata.commit();
  }

 private:
  fs::path folder_;
  std::string file_name_;
  SqliteWriter database_;
};

}  // namespace

std::unique_ptr<BagWriter> create_sqlite_bag(const fs::path& file) {
  return std::make_unique<SqliteWriter>(file);
}

std::unique_ptr<BagWriter> create_rosbag2_folder(const fs::path& folder) {
  return std::make_unique<FolderWriter>(folder);
}

}  // namespace roomatlas::io
