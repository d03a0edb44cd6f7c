// SPDX-License-Identifier: GPL-3.0-or-later
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "io/bags/small_bags.hpp"
#include "support/temporary_folder.hpp"

namespace roomatlas::test::bags {
namespace {

using testing::HasSubstr;

struct Layout {
  bool has_profiles = true;
  bool has_index = true;
  bool packs_messages = false;
};

/// A file as rosbag2's SQLite storage of Dashing (no profiles) or later writes it.
void make_database(const std::filesystem::path& file, const std::vector<Message>& messages,
                   const Layout& layout = {}) {
  SQLite::Database db(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  const std::string more = layout.has_profiles ? ", offered_qos_profiles TEXT NOT NULL" : "";
  db.exec(
      "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
      "serialization_format TEXT NOT NULL" +
      more + ")");
  db.exec(
      "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp "
      "INTEGER NOT NULL, data BLOB NOT NULL)");
  if (layout.has_index) db.exec("CREATE INDEX timestamp_idx ON messages (timestamp ASC)");
  const std::string profile = layout.has_profiles ? ", ''" : "";
  db.exec("INSERT INTO topics VALUES (4, '/a', 'std_msgs/msg/String', 'cdr'" + profile + ")");
  db.exec("INSERT INTO topics VALUES (7, '/b', 'std_msgs/msg/Int32', 'cdr'" + profile + ")");
  for (const Message& message : messages) {
    SQLite::Statement insert(db, "INSERT INTO messages(topic_id, timestamp, data) VALUES (?,?,?)");
    const std::string bytes = layout.packs_messages ? packed("zstd", message.bytes) : message.bytes;
    insert.bind(1, message.topic == "/a" ? 4 : 7);
    insert.bind(2, message.time_ns);
    insert.bind(3, bytes.data(), static_cast<int>(bytes.size()));
    insert.exec();
  }
}

std::vector<Message> recorded() {
  std::vector<Message> all;
  for (const SmallChunk& chunk : small_chunks()) {
    all.insert(all.end(), chunk.messages.begin(), chunk.messages.end());
  }
  return all;
}

/// As a recorder leaves it that is stopped by force: all but the first messages are in the log.
void leave_unclosed(const TemporaryFolder& folder, const std::string& name) {
  const std::vector<Message> all = recorded();
  const std::filesystem::path live = folder / "live.db3";
  make_database(live, {all.begin(), all.begin() + 5});
  SQLite::Database db(live.string(), SQLite::OPEN_READWRITE);
  db.exec("PRAGMA journal_mode = WAL");
  for (std::size_t i = 5; i < all.size(); ++i) {
    SQLite::Statement insert(db, "INSERT INTO messages(topic_id, timestamp, data) VALUES (?,?,?)");
    insert.bind(1, all[i].topic == "/a" ? 4 : 7);
    insert.bind(2, all[i].time_ns);
    insert.bind(3, all[i].bytes.data(), static_cast<int>(all[i].bytes.size()));
    insert.exec();
  }
  std::filesystem::copy(live, folder / name);
  std::filesystem::copy(live.string() + "-wal", (folder / name).string() + "-wal");
}

std::string metadata(const std::vector<std::string>& files, const std::string& compression = "") {
  std::string text =
      "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: sqlite3\n"
      "  message_count: 30\n  topics_with_message_count:\n";
  for (const std::string name : {"/a", "/b"}) {
    text += "    - topic_metadata:\n        name: " + name + "\n        type: std_msgs/msg/" +
            (name == "/a" ? "String" : "Int32") +
            "\n        serialization_format: cdr\n"
            "        offered_qos_profiles: \"- history: 3\\n  depth: 0\"\n      message_count: " +
            (name == "/a" ? "20" : "10") + "\n";
  }
  text += "  compression_format: \"" + compression + "\"\n  relative_file_paths:\n";
  for (const std::string& file : files) text += "    - " + file + "\n";
  return text + "  files:\n    - path: other.db3\n";
}

TEST(Rosbag2, ThatWasNotClosedIsReadWithItsLogAndLeftAsItIs) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "bag");
  leave_unclosed(folder, "bag/a b?.db3");
  const std::filesystem::path file = folder / "bag" / "a b?.db3";
  const std::string before = bytes_of(file) + bytes_of(file.string() + "-wal");
  using std::filesystem::perms;
  std::filesystem::permissions(folder / "bag", perms::owner_read | perms::owner_exec);
  {
    const auto reader = io::open_bag(file);
    EXPECT_EQ(rest_of(*reader), in_time_order(small_chunks()));
    EXPECT_THAT(text_of(reader->issues()), HasSubstr("-wal"));
  }
  std::filesystem::permissions(folder / "bag", perms::owner_all);
  EXPECT_EQ(bytes_of(file) + bytes_of(file.string() + "-wal"), before);
  const auto files = std::distance(std::filesystem::directory_iterator(folder / "bag"), {});
  EXPECT_EQ(files, 2);  // nothing beside
}

TEST(Rosbag2, ThatWasNotClosedAndLostItsLogSaysWhatIsThere) {
  const TemporaryFolder folder;
  leave_unclosed(folder, "a.db3");
  const std::string log = bytes_of(folder / "a.db3-wal");
  folder.write("a.db3-wal", log.substr(0, log.size() / 2));
  const auto cut = io::open_bag(folder / "a.db3");
  const auto some = rest_of(*cut);
  EXPECT_GT(some.size(), 5U);
  EXPECT_LT(some.size(), 30U);
  std::filesystem::remove(folder / "a.db3-wal");
  EXPECT_EQ(rest_of(*io::open_bag(folder / "a.db3")).size(), 5U);
}

TEST(Rosbag2, ReadsFilesOfAllLayouts) {
  for (int bits = 0; bits < 8; ++bits) {
    const TemporaryFolder folder;
    const Layout layout{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
    make_database(folder / "a b?.db3", recorded(), layout);
    const auto reader = io::open_bag(folder / "a b?.db3");
    ASSERT_TRUE(reader);
    EXPECT_EQ(reader->topics()[0].type, "std_msgs/String");
    const std::vector<Message> expected =
        layout.has_index ? in_time_order(small_chunks()) : recorded();
    EXPECT_EQ(rest_of(*reader), expected) << bits;
    EXPECT_EQ(messages_of(folder / "a b?.db3", {"/b"}).size(), 10U);
    // Nothing appears beside it.
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
  }
}

/// So that nobody's sums of times overflow.
TEST(Rosbag2, TimesThatCannotBeAreHeldWithinThoseThatCan) {
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  const TemporaryFolder folder;
  make_database(folder / "a.db3",
                {{"/a", -kMost - 1, "x"}, {"/a", -1, "x"}, {"/a", 5, "x"}, {"/a", kMost, "x"}});
  const auto reader = io::open_bag(folder / "a.db3");
  std::vector<std::int64_t> times;
  for (const Message& message : rest_of(*reader)) times.push_back(message.time_ns);
  EXPECT_THAT(times, testing::ElementsAre(0, 0, 5, io::kLatestTime_ns));
}

/// Of files that are packed the first alone is looked into before its turn.
TEST(Rosbag2, TopicsThatItsMetadataDoesNotListAreCountedAndTheFirstAreNamed) {
  const TemporaryFolder folder;
  const std::vector<Message> all = recorded();
  make_database(folder / "bag_0.db3", {all.begin(), all.begin() + 15});
  make_database(folder / "bag_1.db3", {all.begin() + 15, all.end()});
  {
    SQLite::Database db((folder / "bag_1.db3").string(), SQLite::OPEN_READWRITE);
    SQLite::Transaction inserts(db);
    for (int i = 0; i < 30'000; ++i) {
      db.exec("INSERT INTO topics VALUES (" + std::to_string(100 + i) + ", '/more_" +
              std::to_string(i) + "', 'std_msgs/msg/String', 'cdr', '')");
    }
    inserts.commit();
  }
  std::vector<std::string> files;
  for (const std::string name : {"bag_0.db3", "bag_1.db3"}) {
    files.push_back(name + ".zstd");
    folder.write(files.back(), packed("zstd", bytes_of(folder / name)));
    std::filesystem::remove(folder / name);
  }
  folder.write("metadata.yaml", metadata(files, "zstd"));
  const auto reader = io::open_bag(folder.path());
  EXPECT_EQ(rest_of(*reader).size(), 30U);
  const std::string said = text_of(reader->issues());
  EXPECT_THAT(said, HasSubstr("not in the metadata"));
  EXPECT_THAT(said, HasSubstr("/more_0, /more_1, "));
  EXPECT_THAT(said, HasSubstr("30000 topics"));
  EXPECT_LT(said.size(), 1000U);
}

TEST(Rosbag2, ReadsAFilePackedAsAWhole) {
  const TemporaryFolder folder;
  make_database(folder / "a.db3", recorded());
  folder.write("b.db3.zstd", packed("zstd", bytes_of(folder / "a.db3")));
  EXPECT_EQ(messages_of(folder / "b.db3.zstd"), in_time_order(small_chunks()));
  EXPECT_EQ(io::open_bag(folder / "b.db3.zstd")->format(), "rosbag2 (SQLite, zstd)");
}

TEST(Rosbag2, ReadsAFoldersFilesInTheOrderOfItsMetadata) {
  for (const bool is_packed : {false, true}) {
    const TemporaryFolder folder;
    std::vector<std::string> names;
    for (int part : {0, 1, 2}) {
      // The names' order is not the recording's.
      const std::string name = "run_" + std::to_string(9 - part) + ".db3";
      make_database(folder / name, small_chunks()[static_cast<std::size_t>(part)].messages);
      names.push_back(name + (is_packed ? ".zstd" : ""));
      if (!is_packed) continue;
      folder.write(names.back(), packed("zstd", bytes_of(folder / name)));
      std::filesystem::remove(folder / name);
    }
    folder.write("metadata.yaml", metadata(names, is_packed ? "zstd" : ""));
    const auto reader = io::open_bag(folder.path());
    ASSERT_TRUE(reader);
    EXPECT_EQ(reader->topics()[0].messages, 20);
    EXPECT_EQ(rest_of(*reader), recorded());
    EXPECT_EQ(reader->progress(), 1.0);
  }
}

TEST(Rosbag2, WithoutMetadataFilesAreTakenInTheOrderOfTheirNumbers) {
  const TemporaryFolder folder;
  const char* names[] = {"run_2.db3", "run_10.db3", "run_11.db3"};
  for (std::size_t i = 0; i < 3; ++i) make_database(folder / names[i], small_chunks()[i].messages);
  EXPECT_EQ(messages_of(folder.path()), recorded());
  make_database(folder / "other.db3", {});
  EXPECT_THROW(static_cast<void>(io::open_bag(folder.path())), InputError);
}

TEST(Rosbag2, MissingAndUnlistedFilesAndUnknownPackingsAreNamed) {
  const TemporaryFolder folder;
  make_database(folder / "run_0.db3", small_chunks()[0].messages);
  make_database(folder / "else.db3", small_chunks()[1].messages);
  folder.write("metadata.yaml", metadata({"old_name/run_0.db3", "run_1.db3"}));
  const auto reader = io::open_bag(folder.path());
  EXPECT_EQ(rest_of(*reader).size(), 10U);
  EXPECT_THAT(text_of(reader->issues()), HasSubstr("run_1.db3 is listed"));
  EXPECT_THAT(text_of(reader->issues()), HasSubstr("else.db3 is not listed"));
  folder.write("metadata.yaml", metadata({"run_0.db3"}, "fake_lz"));
  try {
    static_cast<void>(io::open_bag(folder.path()));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("\"fake_lz\""));
  }
}

TEST(Rosbag2, CutOrDamagedAnywhereItIsRefusedOrReadAsFarAsItGoes) {
  const TemporaryFolder folder;
  std::vector<Message> messages;
  for (int i = 0; i < 300; ++i)
    messages.push_back({"/a", i, std::string(500, static_cast<char>(i))});
  make_database(folder / "whole.db3", messages);
  const std::string whole = bytes_of(folder / "whole.db3");
  const auto survivors = [&](const std::string& bytes) -> std::size_t {
    const auto file = folder.write("damaged.db3", bytes);
    try {
      const auto reader = io::open_bag(file);
      return reader ? rest_of(*reader).size() : 0;
    } catch (const InputError&) {
      return 0;
    }
  };
  EXPECT_EQ(survivors(whole), 300U);
  for (std::size_t size = 0; size < whole.size(); size += 1013) {
    EXPECT_LE(survivors(whole.substr(0, size)), 300U);
  }
  for (std::size_t at = 0; at < whole.size(); at += 257) {
    std::string bytes = whole;
    for (std::size_t i = at; i < std::min(at + 3, bytes.size()); ++i) bytes[i] = '\xff';
    survivors(bytes);
  }
  EXPECT_GT(survivors(whole.substr(0, whole.size() * 3 / 4)), 0U);
}

}  // namespace
}  // namespace roomatlas::test::bags
