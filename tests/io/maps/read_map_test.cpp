// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/maps/read_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "roomatlas/core/issue.hpp"

namespace roomatlas {
namespace {

using ::testing::HasSubstr;

class ReadMap : public ::testing::Test {
 protected:
  ReadMap() {
    std::string name = (std::filesystem::temp_directory_path() / "roomatlas-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~ReadMap() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] Path write(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return folder_ / name;
  }
  /// One row of greys as a map by a YAML file with more lines.
  [[nodiscard]] std::string row(const std::string& greys, int count,
                                const std::string& more) const {
    (void)write("row.pgm", "P2 " + std::to_string(count) + " 1 255\n" + greys + "\n");
    const MapCells map = read_map(
        write("row.yaml", "image: row.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n" + more), 0.0);
    std::string text;
    for (const MapCell cell : map.cells.values) {
      text += cell == MapCell::free ? '.' : cell == MapCell::occupied ? '#' : '?';
    }
    return text;
  }
  template <typename Error>
  [[nodiscard]] static std::string message_of(const Path& file, double resolution_m) {
    try {
      (void)read_map(file, resolution_m);
    } catch (const Error& error) {
      return error.what();
    }
    return "nothing was thrown";
  }

  Path folder_;
};

// Occupancy of a grey g is 1 - g / 255: 254 is .004, 205 is .196, 166 is .349, 100 is .608, 0 is 1.
TEST_F(ReadMap, TrinaryTellsFreeUnknownAndOccupiedByTwoThresholds) {
  EXPECT_EQ(row("254 205 166 100 0", 5, ""), ".???#");
  EXPECT_EQ(row("254 205 166 100 0", 5, "occupied_thresh: 0.6\nfree_thresh: 0.25\n"), "..?##");
}

TEST_F(ReadMap, NegateTurnsItRound) { EXPECT_EQ(row("254 150 0", 3, "negate: 1\n"), "#?."); }

TEST_F(ReadMap, ScaleKnowsEveryPixelAndTakesTheNearerSide) {
  EXPECT_EQ(row("254 205 166 100 0", 5, "mode: scale\n"), "...##");  // .423 is the middle
}

TEST_F(ReadMap, RawGreysAreOccupancyInPerCentAndUnknownAbove) {
  EXPECT_EQ(row("0 19 40 65 100 101 255", 7, "mode: raw\n"), "..?##??");
  EXPECT_EQ(row("0 19 40 65 100 101 255", 7, "mode: raw\nnegate: 1\n"), "..?##??");
}

TEST_F(ReadMap, TheFirstCellIsTheLowerLeftOneAndTheOriginIsKept) {
  (void)write("two.pgm", "P2 2 2 255\n0 254\n254 205\n");
  const MapCells map =
      read_map(write("two.yaml", "image: two.pgm\nresolution: 0.2\norigin: [3, -4, 0.5]\n"), 0.0);
  EXPECT_EQ(map.frame.cell_m, 0.2);
  EXPECT_EQ(map.building_from_map, (Pose2{3.0, -4.0, 0.5}));
  EXPECT_EQ(map.cells.get({0, 0}), MapCell::free);
  EXPECT_EQ(map.cells.get({1, 0}), MapCell::unknown);
  EXPECT_EQ(map.cells.get({0, 1}), MapCell::occupied);
}

TEST_F(ReadMap, IsToldFromALogByEndingOrContent) {
  EXPECT_TRUE(is_map(write("a.yaml", "")));
  EXPECT_TRUE(is_map(write("picture", "P2 1 1 255\n254\n")));
  EXPECT_FALSE(is_map(write("a.log", "ODOM 0 0 0 0 0 0 0 h 0\n")));
  EXPECT_FALSE(is_map(folder_ / "missing"));
}

TEST_F(ReadMap, ErrorsNameTheFileAndTheRemedy) {
  const Path bare = write("bare.pgm", "P2 1 1 255\n254\n");
  EXPECT_THAT(message_of<UsageError>(bare, 0.0), HasSubstr("bare.pgm: a picture does not say"));
  EXPECT_THAT(message_of<UsageError>(bare, 0.0), HasSubstr("--resolution METRES"));
  const Path black = write("black.pgm", "P2 1 1 255\n0\n");
  EXPECT_THAT(message_of<NotEnoughError>(black, 0.05), HasSubstr("black.pgm: no pixel is free"));
  const std::string rest = "resolution: 0.1\norigin: [0, 0, 0]\n";
  EXPECT_THAT(message_of<InputError>(write("a.yaml", "image: none.pgm\n" + rest), 0.0),
              HasSubstr("a.yaml:1: image: expected the name of a picture"));
  EXPECT_THAT(
      message_of<InputError>(write("a.yaml", "image: bare.pgm\n" + rest + "free_thresh: 2\n"), 0.0),
      HasSubstr("a.yaml:4: free_thresh: expected a share from 0 to 1"));
  EXPECT_THAT(message_of<InputError>(
                  write("a.yaml", "image: bare.pgm\n" + rest + "occupied_thresh: 0.1\n"), 0.0),
              HasSubstr("a.yaml:4: occupied_thresh: expected at least free_thresh"));
  EXPECT_THAT(message_of<UsageError>(write("a.yaml", "image: bare.pgm\n" + rest), 0.05),
              HasSubstr("leave --resolution out"));
}

}  // namespace
}  // namespace roomatlas
