// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/bags/small_bags.hpp"
#include "support/temporary_folder.hpp"

namespace roomatlas::test::bags {
namespace {

using testing::HasSubstr;

class Ros1Bag : public testing::Test {
 protected:
  std::unique_ptr<io::BagReader> open(const std::string& bytes) {
    return io::open_bag(folder_.write("trace.bag", bytes));
  }
  std::string refusal(const std::string& bytes) {
    try {
      open(bytes);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
};

TEST_F(Ros1Bag, GivesMessagesOfOverlappingChunksInTheOrderOfTimes) {
  for (const std::string packing : {"none", "bz2", "lz4"}) {
    for (const bool is_indexed : {true, false}) {
      const SmallBag bag = small_ros1_bag(packing, is_indexed);
      const auto reader = open(bag.bytes);
      EXPECT_EQ(rest_of(*reader), bag.messages) << packing << is_indexed;
      EXPECT_EQ(reader->format(),
                "ROS 1 bag 2.0" + (packing == "none" ? "" : " (" + packing + ")"));
      EXPECT_EQ(reader->progress(), 1.0);
      const Issues issues = reader->issues();
      EXPECT_EQ(issues.size(), is_indexed ? 0U : 1U) << text_of(issues);
    }
  }
}

TEST_F(Ros1Bag, SaysItsTopicsBeforeMessagesAreRead) {
  for (const bool is_indexed : {true, false}) {
    const auto reader = open(small_ros1_bag("lz4", is_indexed).bytes);
    ASSERT_EQ(reader->topics().size(), 2U);
    const io::BagTopic& a = reader->topics()[0];
    EXPECT_EQ(a.name, "/a");
    EXPECT_EQ(a.type, "std_msgs/String");
    EXPECT_EQ(a.encoding, io::BagEncoding::ros1);
    EXPECT_EQ(a.definition, "string data\n");
    EXPECT_EQ(a.messages, 20);
    EXPECT_EQ(reader->topics()[1].messages, 10);
  }
}

TEST_F(Ros1Bag, DoesNotReadChunksWithoutAWantedTopic) {
  SmallBag bag = small_ros1_bag("lz4");
  // The third chunk has "/a" alone: it may be damaged as it will for who wants "/b".
  for (std::size_t i = bag.chunks[2]; i < bag.chunks[3]; ++i) bag.bytes[i] = '\xee';
  const auto reader = open(bag.bytes);
  const auto messages = rest_of(*reader, {"/b"});
  EXPECT_EQ(messages.size(), 10U);
  for (const Message& message : messages) EXPECT_EQ(message.topic, "/b");
  EXPECT_EQ(text_of(reader->issues()), "");
}

TEST_F(Ros1Bag, ReadsMessagesOutsideOfChunks) {
  std::string bytes = ros1_beginning(0, 1, 0) + ros1_connection(0, "/a", "std_msgs/String");
  std::vector<Message> written;
  for (int i = 0; i < 50; ++i) {
    written.push_back({"/a", 1'000'000'000LL * i, std::string(static_cast<std::size_t>(i), 'x')});
    bytes += ros1_message(0, written.back().time_ns, written.back().bytes);
    if (i == 20) bytes += ros1_record({{"op", "\x63"}}, "of the future");
  }
  EXPECT_EQ(rest_of(*open(bytes)), written);
}

TEST_F(Ros1Bag, CutBehindAChunkItHasAllChunksBefore) {
  for (const std::string packing : {"none", "bz2", "lz4"}) {
    const SmallBag bag = small_ros1_bag(packing);
    for (std::size_t chunks = 1; chunks <= 3; ++chunks) {
      const auto reader = open(bag.bytes.substr(0, bag.chunks[chunks]));
      EXPECT_EQ(rest_of(*reader).size(), 10 * chunks);
      EXPECT_THAT(text_of(reader->issues()), HasSubstr("its index is damaged"));
    }
  }
}

TEST_F(Ros1Bag, CutInsideAPlainChunkItHasTheMessagesThatAreWhole) {
  const SmallBag bag = small_ros1_bag("none");
  const std::size_t last_of_second = bag.bytes.find(std::string(22, 'T'));
  ASSERT_NE(last_of_second, std::string::npos);
  const auto reader = open(bag.bytes.substr(0, last_of_second + 5));
  EXPECT_EQ(rest_of(*reader).size(), 19U);
  EXPECT_THAT(text_of(reader->issues()), HasSubstr("the file ends inside it"));
}

TEST_F(Ros1Bag, MessagesOutsideOfChunksAreReadThoughTheIndexDoesNotTellOfThem) {
  const std::string chunk = ros1_chunk("none", ros1_connection(5, "/a", "std_msgs/String") +
                                                   ros1_message(5, 200, "in the chunk")) +
                            ros1_index(5, {200});
  const std::string open_ones = ros1_connection(5, "/a", "std_msgs/String") +
                                ros1_message(5, 100, "before") + ros1_message(5, 300, "behind");
  for (const bool is_before : {true, false}) {
    const std::string body = is_before ? open_ones + chunk : chunk + open_ones;
    const std::size_t begin = ros1_beginning(0, 0, 0).size();
    const std::string bag =
        ros1_beginning(begin + body.size(), 1, 1) + body +
        ros1_connection(5, "/a", "std_msgs/String") +
        ros1_chunk_info(begin + (is_before ? open_ones.size() : 0), 200, 200, {{5, 1}});
    const auto reader = open(bag);
    EXPECT_EQ(reader->topics().at(0).messages, 3);
    EXPECT_EQ(rest_of(*reader),
              (std::vector<Message>{
                  {"/a", 100, "before"}, {"/a", 200, "in the chunk"}, {"/a", 300, "behind"}}));
    EXPECT_THAT(text_of(reader->issues()), HasSubstr("outside of its chunks"));
  }
}

TEST_F(Ros1Bag, OneDamagedChunkCostsItsMessagesAlone) {
  SmallBag bag = small_ros1_bag("lz4");
  for (std::size_t i = bag.chunks[1] + 80; i < bag.chunks[1] + 120; ++i) bag.bytes[i] = '\x55';
  const auto reader = open(bag.bytes);
  const auto messages = rest_of(*reader);
  EXPECT_GE(messages.size(), 20U);
  EXPECT_LT(messages.size(), 30U);
  EXPECT_THAT(text_of(reader->issues()), HasSubstr("1 chunks"));
}

TEST_F(Ros1Bag, NamesAPackingThatIsNotKnown) {
  SmallBag bag = small_ros1_bag("lz4");
  for (std::size_t at = 0; (at = bag.bytes.find("compression=lz4", at)) != std::string::npos;
       ++at) {
    bag.bytes.replace(at, 15, "compression=lzX");
  }
  const auto reader = open(bag.bytes);
  EXPECT_TRUE(rest_of(*reader).empty());
  EXPECT_THAT(text_of(reader->issues()), HasSubstr("\"lzX\""));
  EXPECT_THAT(text_of(reader->issues()), HasSubstr("3 chunks, 30 messages"));
}

TEST_F(Ros1Bag, OfAnotherVersionOrEncryptedIsRefusedWithTheRemedy) {
  EXPECT_THAT(refusal("#ROSBAG V1.2\n" + std::string(100, 'x')), HasSubstr("rosbag fix"));
  EXPECT_THAT(refusal("#ROSBAG V1.2\n" + std::string(100, 'x')), HasSubstr("(#ROSBAG V1.2)"));
  const std::string encrypted =
      "#ROSBAG V2.0\n" + ros1_record({{"op", "\x03"},
                                      {"index_pos", u64(0)},
                                      {"conn_count", u32(0)},
                                      {"chunk_count", u32(0)},
                                      {"encryptor", "rosbag/AesCbcEncryptor"}},
                                     "");
  EXPECT_THAT(refusal(encrypted), HasSubstr("encrypted"));
  EXPECT_THAT(refusal(ros1_beginning(0, 0, 0)), HasSubstr("nothing was recorded"));
}

TEST_F(Ros1Bag, HoldsAnyNumberOfTopicsUpToALimitThatItSays) {
  std::string bytes = ros1_beginning(0, 300'000, 0);
  for (std::uint32_t i = 0; i < 300'000; ++i) {
    bytes += ros1_connection(i, "/topic" + std::to_string(i), "std_msgs/String");
  }
  bytes += ros1_message(7, 1, "seven") + ros1_message(299'999, 2, "beyond");
  const auto reader = open(bytes);
  EXPECT_EQ(reader->topics().size(), 262'144U);
  EXPECT_EQ(rest_of(*reader), (std::vector<Message>{{"/topic7", 1, "seven"}}));
  EXPECT_THAT(text_of(reader->issues()), HasSubstr("37856 topics"));
}

}  // namespace
}  // namespace roomatlas::test::bags
