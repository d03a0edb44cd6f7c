// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/bags/small_bags.hpp"
#include "support/temporary_folder.hpp"

namespace roomatlas::test::bags {
namespace {

using testing::HasSubstr;

class Mcap : public testing::Test {
 protected:
  std::unique_ptr<io::BagReader> open(const std::string& bytes) {
    return io::open_bag(folder_.write("trace.mcap", bytes));
  }

  TemporaryFolder folder_;
};

McapParts parts_of(unsigned bits, const std::string& packing) {
  const auto has = [&](int bit) { return (bits >> bit & 1U) != 0; };
  McapParts parts;
  parts.packing = packing;
  parts.has_chunks = has(0);
  parts.has_message_index = has(1);
  parts.has_summary = has(2);
  parts.repeats_channels = has(3);
  parts.repeats_schemas = has(4);
  parts.has_statistics = has(5);
  parts.has_chunk_index = has(6);
  parts.has_crcs = has(7);
  parts.padding = has(8) ? 5 : 0;
  return parts;
}

TEST_F(Mcap, IsReadWithAnyOfItsPartsMissingOrPadded) {
  for (const std::string packing : {"", "lz4", "zstd"}) {
    for (unsigned bits = 0; bits < 512; ++bits) {
      const McapParts parts = parts_of(bits, packing);
      const SmallBag bag = small_mcap(parts);
      const auto reader = open(bag.bytes);
      ASSERT_TRUE(reader) << bits;
      ASSERT_EQ(reader->topics().size(), 2U) << packing << bits;
      for (const io::BagTopic& topic : reader->topics()) {
        ASSERT_EQ(topic.type, "std_msgs/String") << packing << bits;
        ASSERT_EQ(topic.encoding, io::BagEncoding::cdr);
        ASSERT_EQ(topic.definition, "string data");
        const bool jumps =
            parts.has_chunks && parts.has_summary && parts.has_chunk_index && !parts.has_statistics;
        if (!jumps) {
          ASSERT_EQ(topic.messages, topic.name == "/a" ? 20 : 10) << packing << bits;
        }
      }
      ASSERT_EQ(rest_of(*reader), bag.messages) << packing << bits;
      ASSERT_EQ(text_of(reader->issues()), "") << packing << bits;
      ASSERT_EQ(messages_of(folder_ / "trace.mcap", {"/b"}).size(), 10U) << packing << bits;
    }
  }
}

TEST_F(Mcap, DoesNotReadChunksWithoutAWantedTopic) {
  McapParts parts = parts_of(~0U, "zstd");
  parts.padding = 0;
  SmallBag bag = small_mcap(parts);
  for (std::size_t i = bag.chunks[2]; i < bag.chunks[3]; ++i) bag.bytes[i] = '\xee';
  const auto reader = open(bag.bytes);
  EXPECT_EQ(rest_of(*reader, {"/b"}).size(), 10U);
  // The data section's CRC alone tells.
  EXPECT_EQ(reader->issues().size(), 1U) << text_of(reader->issues());
}

TEST_F(Mcap, LeavesOutAChunkWithAWrongCrc) {
  for (const bool has_summary : {true, false}) {
    McapParts parts;
    parts.has_summary = has_summary;
    SmallBag bag = small_mcap(parts);
    bag.bytes[bag.bytes.find(std::string(17, 'O'))] = 'o';
    const auto reader = open(bag.bytes);
    EXPECT_EQ(rest_of(*reader).size(), 20U);
    EXPECT_THAT(text_of(reader->issues()), HasSubstr("CRC is wrong"));
    EXPECT_THAT(text_of(reader->issues()), HasSubstr("1 chunks"));
  }
}

TEST_F(Mcap, WithAWrongSummaryIsReadWithoutIt) {
  SmallBag bag = small_mcap({});
  bag.bytes[bag.bytes.rfind("/a")] = '#';  // of the repeated channel
  const auto reader = open(bag.bytes);
  EXPECT_EQ(rest_of(*reader), bag.messages);
  EXPECT_THAT(text_of(reader->issues()), HasSubstr("its summary is damaged (its CRC is wrong)"));
}

TEST_F(Mcap, CutBehindAChunkItHasAllChunksBefore) {
  for (const std::string packing : {"", "lz4", "zstd"}) {
    McapParts parts;
    parts.packing = packing;
    const SmallBag bag = small_mcap(parts);
    for (std::size_t chunks = 1; chunks <= 3; ++chunks) {
      const auto reader = open(bag.bytes.substr(0, bag.chunks[chunks]));
      EXPECT_EQ(rest_of(*reader).size(), 10 * chunks) << packing;
      EXPECT_THAT(text_of(reader->issues()), HasSubstr("its end is missing"));
    }
  }
}

TEST_F(Mcap, NamesAPackingThatIsNotKnown) {
  SmallBag bag = small_mcap({.packing = "zstd", .has_crcs = false});
  for (std::size_t at = 0; (at = bag.bytes.find("zstd", at)) != std::string::npos; ++at) {
    bag.bytes.replace(at, 4, "snap");
  }
  const auto reader = open(bag.bytes);
  EXPECT_TRUE(rest_of(*reader).empty());
  EXPECT_THAT(text_of(reader->issues()), HasSubstr("\"snap\""));
  EXPECT_THAT(text_of(reader->issues()), HasSubstr("3 chunks"));
}

TEST_F(Mcap, TimesThatCannotBeAreHeldWithinThoseThatCan) {
  const std::string bytes = kMcapMagic + mcap_header() + mcap_schema(1, "std_msgs/msg/String") +
                            mcap_channel(1, 1, "/a") + mcap_message(1, 5, "x") +
                            mcap_message(1, -1, "x") + mcap_record(15, u32(0)) + mcap_footer(0, 0);
  const auto messages = rest_of(*open(bytes));
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[0].time_ns, 5);
  EXPECT_EQ(messages[1].time_ns, io::kLatestTime_ns);
}

TEST_F(Mcap, LargePlainChunkIsReadMessageByMessage) {
  std::string records = mcap_schema(1, "std_msgs/msg/String") + mcap_channel(1, 1, "/a");
  for (int i = 0; i < 20; ++i) records += mcap_message(1, i, std::string(1'000'000, 'x'));
  const std::string bytes = kMcapMagic + mcap_header() + mcap_chunk("", records, 0, 19, 0) +
                            mcap_record(15, u32(0)) + mcap_footer(0, 0);
  EXPECT_EQ(rest_of(*open(bytes)).size(), 20U);
}

}  // namespace
}  // namespace roomatlas::test::bags
