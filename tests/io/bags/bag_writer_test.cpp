// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/bag_writers.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "bags/ros1_md5.hpp"
#include "io/bags/small_bags.hpp"
#include "support/temporary_folder.hpp"

namespace roomatlas::test::bags {
namespace {

/// A few chunks' worth of two topics, times not in order.
std::vector<Message> many_messages() {
  std::vector<Message> messages;
  for (int i = 0; i < 5000; ++i) {
    const std::int64_t time_ns =
        1'700'000'000'000'000'000 + 1'000'000LL * i - (i % 7) * 900'000'000LL;
    std::string bytes = std::string("\0\1\0\0", 4);
    for (int k = 0; k < 100 + i % 900; ++k) bytes += static_cast<char>(k * i % 251);
    messages.push_back({i % 3 == 0 ? "/a" : "/b", time_ns, bytes});
  }
  return messages;
}

void write(io::BagWriter& writer, const std::vector<Message>& messages) {
  const io::BagEncoding encoding =
      writer.takes(io::BagEncoding::ros1) ? io::BagEncoding::ros1 : io::BagEncoding::cdr;
  writer.add_topic({"/a", "std_msgs/String", encoding, "string data\n", {}});
  writer.add_topic({"/b", "std_msgs/Int32", encoding, "int32 data\n", {}});
  for (const Message& message : messages) {
    writer.write(message.topic == "/a" ? 0 : 1, message.time_ns,
                 std::as_bytes(std::span(message.bytes)));
  }
  writer.finish();
}

std::vector<Message> by_time(std::vector<Message> messages) {
  std::stable_sort(messages.begin(), messages.end(),
                   [](const Message& a, const Message& b) { return a.time_ns < b.time_ns; });
  return messages;
}

TEST(BagWriter, WritesWhatItsReaderReads) {
  const TemporaryFolder folder;
  const std::vector<Message> messages = many_messages();
  for (const std::string name : {"t.bag", "t.mcap", "t.db3", "t", "u/"}) {
    write(*io::create_bag(folder / name), messages);
    const auto reader = io::open_bag(folder / name);
    ASSERT_TRUE(reader) << name;
    ASSERT_EQ(reader->topics().size(), 2U);
    EXPECT_EQ(reader->topics()[0].type, "std_msgs/String");
    EXPECT_EQ(reader->topics()[1].definition, "int32 data\n") << name;
    if (name != "t.db3") {
      EXPECT_EQ(reader->topics()[0].messages, 1667) << name;
    }
    EXPECT_TRUE(rest_of(*reader) == by_time(messages)) << name;
    EXPECT_EQ(text_of(reader->issues()), "") << name;
  }
}

TEST(BagWriter, PacksRos1ChunksByAnyOfItsPackings) {
  const TemporaryFolder folder;
  const std::vector<Message> messages = many_messages();
  for (const io::Packing packing : {io::Packing::none, io::Packing::bz2, io::Packing::lz4}) {
    write(*io::create_ros1_bag(folder / "t.bag", packing), messages);
    EXPECT_TRUE(messages_of(folder / "t.bag") == by_time(messages));
  }
  EXPECT_THROW(io::create_ros1_bag(folder / "t.bag", io::Packing::zstd), std::invalid_argument);
}

TEST(BagWriter, WritesTheSameBytesTwice) {
  const TemporaryFolder folder;
  for (const std::string ending : {".bag", ".mcap", ".db3"}) {
    for (const std::string name : {"first", "second"}) {
      write(*io::create_bag(folder / (name + ending)), many_messages());
    }
    EXPECT_TRUE(bytes_of(folder / ("first" + ending)) == bytes_of(folder / ("second" + ending)));
  }
}

TEST(BagWriter, LeavesNothingBehindUnlessItIsFinished) {
  const TemporaryFolder folder;
  for (const std::string name : {"t.bag", "t.mcap", "t.db3"}) {
    const auto writer = io::create_bag(folder / name);
    writer->add_topic(
        {"/a",
         "std_msgs/String",
         writer->takes(io::BagEncoding::cdr) ? io::BagEncoding::cdr : io::BagEncoding::ros1,
         "",
         {}});
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_THROW(io::create_bag(folder / "t.txt"), InputError);
  EXPECT_THROW(io::create_bag(folder / "missing" / "t.db3"), InputError);
}

TEST(BagWriter, WithoutMessagesItIsARecordingAllTheSame) {
  const TemporaryFolder folder;
  for (const std::string name : {"t.bag", "t.mcap", "t.db3"}) {
    write(*io::create_bag(folder / name), {});
    EXPECT_TRUE(messages_of(folder / name).empty()) << name;
  }
}

/// As `rosmsg md5` prints them.
TEST(BagWriter, SumsOfTypesAreRos1s) {
  EXPECT_EQ(io::ros1_md5("std_msgs/String", "string data\n"), "992ce8a1687cec8c8bd883ec73ca41d1");
  const std::string header =
      "# Standard metadata\nuint32 seq\n#stamp\ntime stamp\nstring frame_id # which frame\n";
  EXPECT_EQ(io::ros1_md5("std_msgs/Header", header), "2176decaecbce78abc3b96ef049fabed");
  EXPECT_EQ(io::ros1_md5("sensor_msgs/LaserScan",
                         "Header header\nfloat32 angle_min\nfloat32 angle_max\n"
                         "float32 angle_increment\nfloat32 time_increment\nfloat32 scan_time\n"
                         "float32 range_min\nfloat32 range_max\nfloat32[] ranges\n"
                         "float32[] intensities\n====\nMSG: std_msgs/Header\n" +
                             header),
            "90c7ef2dc6895d81024acba2ac42f369");
  EXPECT_EQ(io::ros1_md5("a/B", "C inner\n"), "*");
}

}  // namespace
}  // namespace roomatlas::test::bags
