// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <random>

#include "io/bags/small_bags.hpp"
#include "support/temporary_folder.hpp"

namespace roomatlas::test::bags {
namespace {

using testing::HasSubstr;

struct Sample {
  std::string name;
  SmallBag bag;
};

std::vector<Sample> samples() {
  std::vector<Sample> all;
  for (const std::string packing : {"none", "bz2", "lz4"}) {
    all.push_back({packing + ".bag", small_ros1_bag(packing)});
    all.push_back({packing + ".bag.active", small_ros1_bag(packing, false)});
  }
  for (const std::string packing : {"", "lz4", "zstd"}) {
    all.push_back({packing + ".mcap", small_mcap({.packing = packing})});
    all.push_back({packing + "_bare.mcap", small_mcap({.packing = packing,
                                                       .has_message_index = false,
                                                       .has_summary = false,
                                                       .has_crcs = false})});
  }
  all.push_back({"open.mcap", small_mcap({.packing = "", .has_chunks = false})});
  return all;
}

/// Megabytes that this process has ever held.
long peak_mb() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

/// All messages that can be read; an InputError is an answer too, any other exception fails the
/// test.
std::vector<Message> survivors(const std::filesystem::path& file, std::string& said) {
  try {
    const auto bag = io::open_bag(file);
    if (!bag) return {};
    auto messages = rest_of(*bag);
    said = text_of(bag->issues());
    return messages;
  } catch (const InputError& error) {
    said = error.what();
    return {};
  }
}

TEST(DamagedBag, CutAnywhereLosesOnlyWhatIsCutOffAndSaysSo) {
  const TemporaryFolder folder;
  for (const auto& [name, bag] : samples()) {
    std::size_t most = 0;
    for (std::size_t size = 0; size < bag.bytes.size(); size += size < 4000 ? 97 : 3) {
      std::string said;
      const auto messages = survivors(folder.write(name, bag.bytes.substr(0, size)), said);
      for (const Message& message : messages) {
        ASSERT_TRUE(std::find(bag.messages.begin(), bag.messages.end(), message) !=
                    bag.messages.end())
            << name << " cut at " << size << ": " << message;
      }
      std::size_t whole = 0;
      while (whole < 3 && bag.chunks[whole + 1] <= size) ++whole;
      ASSERT_GE(messages.size(), 10 * whole) << name << " cut at " << size;
      if (size > 16) {
        ASSERT_NE(said, "") << name << " cut at " << size;
      }
      most = std::max(most, messages.size());
    }
    EXPECT_EQ(most, bag.messages.size()) << name;
  }
}

TEST(DamagedBag, FlippedBytesNeverCrashNorTakeMuchMemory) {
  const TemporaryFolder folder;
  std::mt19937 random(20);
  const long before_mb = peak_mb();
  for (const auto& [name, bag] : samples()) {
    for (int round = 0; round < 400; ++round) {
      std::string bytes = bag.bytes;
      const int flips = 1 + static_cast<int>(random() % 4);
      for (int i = 0; i < flips; ++i) {
        // The padding of a ROS 1 bag's header is not worth it.
        const std::size_t first =
            name.find(".bag") != std::string::npos && random() % 8 != 0 ? 4000 : 0;
        const std::size_t at = first + random() % (bytes.size() - first);
        bytes[at] = static_cast<char>(random() % 3 == 0 ? 0xff : random());
      }
      std::string said;
      survivors(folder.write(name, bytes), said);
    }
  }
  EXPECT_LT(peak_mb() - before_mb, 300);
}

TEST(DamagedBag, ClaimsOfGigabytesTakeNoMemory) {
  const TemporaryFolder folder;
  const long before_mb = peak_mb();
  for (const std::string packing : {"none", "bz2", "lz4"}) {
    const std::string records =
        ros1_connection(0, "/a", "std_msgs/String") + ros1_message(0, 1, "x");
    const std::string chunk =
        ros1_record({{"op", "\x05"}, {"compression", packing}, {"size", u32(0xffffffff)}},
                    packed(packing, records));
    std::string said;
    survivors(folder.write("claims.bag", ros1_beginning(0, 1, 1) + chunk), said);
    EXPECT_THAT(said, HasSubstr("claims more than 1 GiB"));
  }
  for (const std::string packing : {"", "lz4", "zstd"}) {
    const std::string records =
        mcap_schema(1, "std_msgs/msg/String") + mcap_channel(1, 1, "/a") + mcap_message(1, 1, "x");
    const std::string content = packed(packing, records);
    const std::string chunk =
        mcap_record(6, u64(1) + u64(1) + u64(std::uint64_t{1} << 32) + u32(0) + block(packing) +
                           u64(content.size()) + content);
    std::string said;
    survivors(folder.write("claims.mcap", kMcapMagic + mcap_header() + chunk), said);
    EXPECT_NE(said, "");
    // Just below what is refused: memory is not filled, so it is not taken.
    const std::string less = mcap_record(6, u64(1) + u64(1) + u64(1'000'000'000) + u32(0) +
                                                block(packing) + u64(content.size()) + content);
    survivors(folder.write("less.mcap", kMcapMagic + mcap_header() + less), said);
    EXPECT_NE(said, "");
  }
  EXPECT_LT(peak_mb() - before_mb, 200);
}

TEST(DamagedBag, AChunkThatNobodyIndexedAndThatCannotBeReadIsSaid) {
  const TemporaryFolder folder;
  const auto chunk = [](const std::string& topics, std::uint32_t checksum) {
    return mcap_chunk("", topics + mcap_message(1, 1, "x"), 1, 1, checksum);
  };
  const std::string topics = mcap_schema(1, "std_msgs/msg/String") + mcap_channel(1, 1, "/a");
  std::string said;
  const auto messages = survivors(
      folder.write("a.mcap", kMcapMagic + mcap_header() + chunk(topics, 0) + chunk("", 7)), said);
  EXPECT_EQ(messages.size(), 1U);
  EXPECT_THAT(said, HasSubstr("a chunk was left out, or its rest behind what is whole: its CRC"));
}

TEST(DamagedBag, OtherFilesAreNotTakenForRecordings) {
  const TemporaryFolder folder;
  EXPECT_EQ(io::open_bag(folder.write("a.txt", "FLASER 0 0 0\n")), nullptr);
  EXPECT_EQ(io::open_bag(folder.write("empty", "")), nullptr);
  EXPECT_EQ(io::open_bag(folder.write("b.zst", packed("zstd", "some text that is packed"))),
            nullptr);
  EXPECT_EQ(io::open_bag(folder.path()), nullptr);
  EXPECT_THROW(static_cast<void>(io::open_bag(folder / "missing")), InputError);
}

}  // namespace
}  // namespace roomatlas::test::bags
