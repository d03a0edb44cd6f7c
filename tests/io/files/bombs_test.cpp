// SPDX-License-Identifier: GPL-3.0-or-later
// Small files that unpack to much, or claim much: refused before they fill memory, disk or time.
#include <gmock/gmock.h>
#include <zlib.h>

#include <algorithm>

#include "io/bags/small_bags.hpp"
#include "pictures/picture.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/maps/read_map.hpp"
#include "roomatlas/io/plans/edits_file.hpp"
#include "roomatlas/io/plans/rooms_geojson.hpp"
#include "roomatlas/io/trajectories/tum.hpp"
#include "support/temporary_folder.hpp"

namespace roomatlas::test {
namespace {

using ::testing::HasSubstr;

constexpr std::size_t kBlock = std::size_t{1} << 20;

template <typename Read>
std::string refusal_of(const Read& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

/// A gzip file of `begin` and 200 MiB of the same text.
Path gzip_bomb(const TemporaryFolder& folder, const std::string& begin, const std::string& text) {
  const Path file = folder / "bomb.gz";
  const gzFile out = gzopen(file.c_str(), "wb9");
  gzwrite(out, begin.data(), static_cast<unsigned>(begin.size()));
  std::string block;
  while (block.size() < kBlock) block += text;
  for (int i = 0; i < 200; ++i) gzwrite(out, block.data(), static_cast<unsigned>(block.size()));
  gzclose(out);
  return file;
}

TEST(Bombs, OfGzipAreRefused) {
  const TemporaryFolder folder;
  const Path text = gzip_bomb(folder, "", "0 0 0 0 0 0 0 1\n");
  EXPECT_LT(std::filesystem::file_size(text), kBlock);
  EXPECT_THAT(refusal_of([&] { (void)read_tum(text); }),
              HasSubstr("bomb.gz: its gzip data grows to more than 256 times its size"));
  const Path picture = gzip_bomb(folder, "P5 10000 10000 255\n", std::string(64, '\0'));
  EXPECT_THAT(refusal_of([&] { (void)read_map(picture, 0.05); }), HasSubstr("unpack it with"));
}

/// Less than what text may grow to; a map of it would take a gigabyte.
TEST(Bombs, OfPackedPicturesAreRefusedSooner) {
  const TemporaryFolder folder;
  const Path file = folder / "wide.pgm.gz";
  const gzFile out = gzopen(file.c_str(), "wb9");
  const std::string text = "P5 8000 8000 255\n" + std::string(64'000'000, '\xfe');
  gzwrite(out, text.data(), static_cast<unsigned>(text.size()));
  gzclose(out);
  EXPECT_LT(std::filesystem::file_size(file), kBlock);
  EXPECT_THAT(refusal_of([&] { (void)read_map(file, 0.05); }),
              HasSubstr("wide.pgm.gz: its gzip data grows to more than a picture of a building"));
}

TEST(Bombs, OfPicturesAreRefusedByWhatTheyClaim) {
  const TemporaryFolder folder;
  const std::string png = std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\xff\xff\0\0\xff\xff", 24);
  EXPECT_THAT(refusal_of([&] { (void)io::parse_picture(png, "a.png"); }),
              HasSubstr("a.png: has 65535 x 65535 pixels, expected at most 33554432"));
  EXPECT_THAT(refusal_of([&] { (void)io::parse_picture("P2 16000 16000 255\n0 0\n", "a.pgm"); }),
              HasSubstr("a.pgm: cut short: 16000 x 16000 pixels need at least 511999999 bytes"));
}

TEST(Bombs, OfZstdAreNotUnpackedToDisk) {
  const TemporaryFolder folder;
  const std::string bytes = bags::kMcapMagic + std::string(100 * kBlock, '\0');
  const Path file = folder.write("bomb.mcap.zst", bags::packed("zstd", bytes));
  EXPECT_THAT(refusal_of([&] { (void)io::open_bag(file); }),
              HasSubstr("bomb.mcap.zst: its zstd data grows to more than 1024 times its size"));
}

/// What a recording of one such chunk after another says.
std::string said_of_chunks(const std::string& packing, std::size_t megabytes, int count) {
  const TemporaryFolder folder;
  const std::string records = bags::mcap_schema(1, "std_msgs/msg/String") +
                              bags::mcap_channel(1, 1, "/a") +
                              bags::mcap_message(1, 1, std::string(megabytes * kBlock, '\0'));
  const std::string chunk = bags::mcap_chunk(packing, records, 1, 1, 0, 0);
  std::string file = bags::kMcapMagic + bags::mcap_header();
  for (int i = 0; i < count; ++i) file += chunk;
  const auto bag = io::open_bag(folder.write("bomb.mcap", file));
  (void)bags::rest_of(*bag);
  return bags::text_of(bag->issues());
}

TEST(Bombs, OfChunksAreLeftOutAndTold) {
  EXPECT_THAT(refusal_of([] { (void)said_of_chunks("zstd", 100, 1); }),
              HasSubstr("it claims to grow to more than 256 times its size"));
  EXPECT_THAT(said_of_chunks("zstd", 40, 6),
              HasSubstr("the chunks before it are more than 1024 times the file's size"));
}

TEST(Bombs, OfNestingAreRefused) {
  const TemporaryFolder folder;
  const std::string deep(2 * kBlock, '[');
  EXPECT_THAT(refusal_of([&] { (void)read_any_plan(folder.write("a.geojson", deep)); }),
              HasSubstr("a.geojson"));
  EXPECT_THAT(refusal_of([&] { (void)edits_of(deep, "edits.json"); }), HasSubstr("edits.json"));
  const std::string closed = deep + std::string(deep.size(), ']');
  EXPECT_THAT(refusal_of([&] { (void)read_any_plan(folder.write("b.geojson", closed)); }),
              HasSubstr("b.geojson"));
  const std::string within =
      R"({"type":"FeatureCollection","features":[{"type":"Feature","geometry":
{"type":"Point","coordinates":)" +
      closed + "}}]}";
  EXPECT_THAT(refusal_of([&] { (void)read_any_plan(folder.write("c.geojson", within)); }),
              HasSubstr("c.geojson: nests deeper than 64 levels"));
}

}  // namespace
}  // namespace roomatlas::test
