// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/maps/read_world.hpp"
#include "roomatlas/io/pictures/svg_pictures.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "support/shared_data.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <random>

namespace roomatlas {
namespace {

using testing::HasSubstr;

/// A drawing as P5: `#` black, `.` white, `?` grey 205, a digit the value itself.
std::string pgm(const std::vector<std::string>& rows) {
  std::string bytes = "P5\n# drawn\n" + std::to_string(rows.front().size()) + " " +
                      std::to_string(rows.size()) + "\n255\n";
  for (const std::string& row : rows) {
    for (const char c : row) {
      const int value = c == '#' ? 0 : c == '.' ? 255 : c == '?' ? 205 : c - '0';
      bytes += static_cast<char>(static_cast<unsigned char>(value));
    }
  }
  return bytes;
}

std::string text_pgm(const std::vector<std::string>& rows) {
  std::string text =
      "P2 " + std::to_string(rows.front().size()) + " " + std::to_string(rows.size()) + " 255\n";
  for (const std::string& row : rows) {
    for (const char c : row) text += c == '#' ? "0 " : c == '.' ? "255 " : "205 ";
    text += "\n";
  }
  return text;
}

bool is_in(const std::vector<Polygon>& polygons, const Point2& point) {
  return std::any_of(polygons.begin(), polygons.end(),
                     [&](const Polygon& polygon) { return contains(polygon, point); });
}

double area_of(const std::vector<Polygon>& polygons) {
  double sum_m2 = 0.0;
  for (const Polygon& polygon : polygons) sum_m2 += area(polygon);
  return sum_m2;
}

template <typename Error>
std::string message_of(const Path& file, const WorldFileOptions& options) {
  try {
    (void)read_world(file, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

const std::vector<std::string> kTwoRooms = {"###########",  //
                                            "#....#....#",  //
                                            "#.........#",  //
                                            "#.........#",  //
                                            "#....#....#",  //
                                            "###########"};

const std::vector<std::string> kTwoLabels = {"00000000000",  //
                                             "01111022220",  //
                                             "01111022220",  //
                                             "01111022220",  //
                                             "01111022220",  //
                                             "00000000000"};

class WorldPicture : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
};

TEST_F(WorldPicture, WallsStandWhereThePictureIsBlack) {
  const FloorPlan world = read_world(folder_.write("map.pgm", pgm(kTwoRooms)), {0.2, {}});
  EXPECT_EQ(world.title, "map");
  ASSERT_EQ(world.walls.size(), 1U);
  for (std::size_t row = 0; row < kTwoRooms.size(); ++row) {
    for (std::size_t column = 0; column < kTwoRooms[row].size(); ++column) {
      const Point2 center(0.2 * (static_cast<double>(column) + 0.5),
                          0.2 * (static_cast<double>(kTwoRooms.size() - row) - 0.5));
      EXPECT_EQ(is_in(world.walls, center), kTwoRooms[row][column] == '#') << center.transpose();
    }
  }
  EXPECT_TRUE(world.rooms.empty());
  EXPECT_TRUE(world.doors.empty());
}

TEST_F(WorldPicture, OutlinesHaveCornersOnly) {
  const FloorPlan world = read_world(folder_.write("map.pgm", pgm(kTwoRooms)), {0.25, {}});
  EXPECT_EQ(world.walls[0].outer, (Ring{{2.75, 0}, {2.75, 1.5}, {0, 1.5}, {0, 0}}));
  ASSERT_EQ(world.walls[0].holes.size(), 1U);
  EXPECT_EQ(world.walls[0].holes[0].size(), 12U);
  EXPECT_LT(signed_area(world.walls[0].holes[0]), 0.0);
}

TEST_F(WorldPicture, ATextPgmAndAPackedPgmGiveTheSameWorld) {
  const std::string bytes = pgm(kTwoRooms);
  const Path packed = folder_ / "map.pgm.gz";
  gzFile stream = gzopen(packed.c_str(), "wb");
  ASSERT_EQ(gzwrite(stream, bytes.data(), static_cast<unsigned>(bytes.size())),
            static_cast<int>(bytes.size()));
  gzclose(stream);
  const std::string binary = to_geojson(read_world(folder_.write("map.pgm", bytes), {0.2, {}}));
  EXPECT_EQ(to_geojson(read_world(packed, {0.2, {}})), binary);
  EXPECT_EQ(to_geojson(read_world(folder_.write("map.PGM", text_pgm(kTwoRooms)), {0.2, {}})),
            binary);
}

TEST_F(WorldPicture, APngGivesTheWorldThatWasDrawn) {
  const Path file = folder_ / "map.png";
  write_png(file,
            R"(<svg xmlns="http://www.w3.org/2000/svg" width="40" height="20">)"
            R"(<rect width="40" height="20" fill="white"/><path d="M0 0H40V5H0Z"/></svg>)",
            96.0);
  const FloorPlan world = read_world(file, {0.1, {}});
  EXPECT_TRUE(is_in(world.walls, {2.0, 1.75}));  // the upper quarter
  EXPECT_FALSE(is_in(world.walls, {2.0, 1.25}));
  EXPECT_FALSE(is_in(world.walls, {2.0, 0.25}));
}

TEST_F(WorldPicture, UnknownCellsAreWallsWhereTheyTouchFreeOnesAndNowhereElse) {
  const FloorPlan world =
      read_world(folder_.write("map.pgm", pgm({"?????", "?????", "..???"})), {1, {}});
  EXPECT_TRUE(is_in(world.walls, {2.5, 0.5}));
  EXPECT_TRUE(is_in(world.walls, {2.5, 1.5}));  // touches by a corner
  EXPECT_FALSE(is_in(world.walls, {3.5, 0.5}));
  EXPECT_FALSE(is_in(world.walls, {0.5, 2.5}));
  EXPECT_TRUE(is_in(world.walls, {0.5, -0.5}));  // beyond the picture
  EXPECT_FALSE(is_in(world.walls, {0.5, 0.5}));
  ASSERT_EQ(world.issues.size(), 1U);
  EXPECT_THAT(world.issues[0].message, HasSubstr("10 unknown cells"));
}

TEST_F(WorldPicture, OfARandomPictureEveryCellIsInTheWallsExactlyWhereItIsBlackOrOnTheRim) {
  std::mt19937 random(7);
  std::vector<std::string> rows(40, std::string(60, '.'));
  for (std::string& row : rows) {
    for (char& c : row) c = random() % 5 < 2 ? '#' : '.';
  }
  const FloorPlan world = read_world(folder_.write("map.pgm", pgm(rows)), {0.5, {}});
  int black = 0;
  for (int row = 0; row < 40; ++row) {
    for (int column = 0; column < 60; ++column) {
      const Point2 center(0.5 * (column + 0.5), 0.5 * (39 - row + 0.5));
      const bool is_black =
          rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] == '#';
      black += is_black ? 1 : 0;
      ASSERT_EQ(std::count_if(world.walls.begin(), world.walls.end(),
                              [&](const Polygon& wall) { return contains(wall, center); }),
                is_black ? 1 : 0);
    }
  }
  double rim_m2 = 0.0;  // cells around the picture, counted one by one
  for (int x = -1; x <= 60; ++x) {
    for (int y = -1; y <= 40; ++y) {
      const Point2 center(0.5 * (x + 0.5), 0.5 * (y + 0.5));
      const bool is_beyond = x < 0 || y < 0 || x == 60 || y == 40;
      if (is_beyond && is_in(world.walls, center)) rim_m2 += 0.25;
    }
  }
  EXPECT_NEAR(area_of(world.walls), 0.25 * black + rim_m2, 1e-6);
  EXPECT_GT(rim_m2, 0.0);
}

TEST_F(WorldPicture, LabelsBecomeRoomsAndTheirContactADoor) {
  const FloorPlan world = read_world(folder_.write("map.pgm", pgm(kTwoRooms)),
                                     {0.25, folder_.write("rooms.pgm", pgm(kTwoLabels))});
  ASSERT_EQ(world.rooms.size(), 2U);
  EXPECT_EQ(world.rooms[0].id, 1);
  EXPECT_EQ(world.rooms[1].id, 2);
  EXPECT_NEAR(world.rooms[0].area_m2 + world.rooms[1].area_m2, 34 * 0.0625, 1e-9);
  ASSERT_EQ(world.doors.size(), 1U);
  EXPECT_EQ(world.doors[0].room_a, 1);
  EXPECT_EQ(world.doors[0].room_b, 2);
  EXPECT_NEAR(world.doors[0].width_m, 0.5, 1e-9);
  const Point2 middle = (world.doors[0].jambs.a + world.doors[0].jambs.b) / 2.0;
  EXPECT_NEAR(middle.x(), 1.375, 0.13);  // at one of the two sides of the wall
  EXPECT_NEAR(middle.y(), 0.75, 1e-9);
}

TEST_F(WorldPicture, RoomsWhoseLabelsKeepApartHaveNoDoorsAndThisIsSaid) {
  std::vector<std::string> labels = kTwoLabels;
  for (std::string& row : labels) std::fill(row.begin() + 3, row.begin() + 8, '0');
  const FloorPlan world = read_world(folder_.write("map.pgm", pgm(kTwoRooms)),
                                     {0.25, folder_.write("rooms.pgm", pgm(labels))});
  EXPECT_TRUE(world.doors.empty());
  ASSERT_FALSE(world.issues.empty());
  EXPECT_THAT(world.issues.back().message, HasSubstr("no two labels touch"));
}

TEST_F(WorldPicture, LabelsOfAnotherSizeAreRefused) {
  const Path labels = folder_.write("rooms.pgm", pgm({"11", "11"}));
  const Path map = folder_.write("map.pgm", pgm(kTwoRooms));
  EXPECT_THAT(message_of<InputError>(map, {0.25, labels}), HasSubstr("11 x 6"));
  EXPECT_THAT(message_of<InputError>(map, {0.25, labels}), HasSubstr("2 x 2"));
}

TEST_F(WorldPicture, ABarePictureWithoutResolutionIsRefused) {
  EXPECT_THAT(message_of<UsageError>(folder_.write("map.pgm", pgm(kTwoRooms)), {}),
              HasSubstr("metres a pixel"));
}

TEST_F(WorldPicture, ANav2MapIsPlacedTurnedAndReadByItsThresholds) {
  folder_.write("floor.pgm", pgm(kTwoRooms));
  const Path yaml = folder_.write("floor.yaml",
                                  "# a map\nimage: \"floor.pgm\"\nresolution: 0.2  # metres\n"
                                  "origin: [10, -5, 1.5707963267948966]\nnegate: 0\n"
                                  "occupied_thresh: 0.65\nfree_thresh: 0.25\nmode: trinary\n");
  const FloorPlan world = read_world(yaml, {});
  EXPECT_EQ(world.title, "floor");
  // column 5, row 0 from below, is black: (1.1, 0.1) in the picture, turned to (-0.1, 1.1)
  EXPECT_TRUE(is_in(world.walls, {9.9, -3.9}));
  EXPECT_FALSE(is_in(world.walls, {9.5, -3.9}));  // (1.1, 0.5): the doorway
}

TEST_F(WorldPicture, NegateSwapsBlackAndWhite) {
  folder_.write("floor.pgm", pgm({"...", ".#.", "..."}));
  const Path yaml = folder_.write(
      "floor.yaml", "image: floor.pgm\nresolution: 1\norigin:\n  - 0\n  - 0\n  - 0\nnegate: 1\n");
  const FloorPlan world = read_world(yaml, {});
  EXPECT_FALSE(is_in(world.walls, {1.5, 1.5}));
  EXPECT_TRUE(is_in(world.walls, {0.5, 0.5}));
}

TEST_F(WorldPicture, WhatIsWrongInANav2MapIsSaidWithItsLine) {
  folder_.write("floor.pgm", pgm(kTwoRooms));
  const auto error = [&](const std::string& text) {
    return message_of<InputError>(folder_.write("floor.yaml", text), {});
  };
  EXPECT_THAT(error("resolution: 0.1\norigin: [0, 0, 0]\n"), HasSubstr("image: is missing"));
  EXPECT_THAT(error("image: floor.pgm\nresolution: fine\norigin: [0, 0, 0]\n"),
              HasSubstr("floor.yaml:2: resolution: expected metres a pixel"));
  EXPECT_THAT(error("image: floor.pgm\nresolution: 0.1\norigin: [0, 0]\n"),
              HasSubstr("floor.yaml:3: origin: expected [x, y, yaw]"));
  EXPECT_THAT(error("image: floor.pgm\nresolution: 0.1\norigin: [0, 0, 0]\nmode: best\n"),
              HasSubstr("floor.yaml:4: mode: expected trinary, scale or raw"));
  EXPECT_THAT(error("image: none.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n"),
              HasSubstr("floor.yaml:1: image: expected the name of a picture beside this file"));
}

TEST_F(WorldPicture, PicturesThatAreCutShortOrAllBlackAreRefused) {
  const std::string whole = pgm(kTwoRooms);
  EXPECT_THAT(message_of<InputError>(folder_.write("map.pgm", whole.substr(0, whole.size() - 3)),
                                     {0.1, {}}),
              HasSubstr("66 bytes, and there are 63"));
  EXPECT_THAT(message_of<InputError>(folder_.write("map.pgm", "P2 2 2 255\n0 0 0"), {0.1, {}}),
              HasSubstr("need at least 7 bytes, and there are 5"));
  EXPECT_THAT(message_of<InputError>(folder_.write("map.pgm", pgm({"##", "##"})), {0.1, {}}),
              HasSubstr("no pixel is free"));
  EXPECT_THAT(message_of<InputError>(folder_.write("map.png", "\x89PNG\r\n\x1a\nrest"), {0.1, {}}),
              HasSubstr("not a PNG that can be read"));
}

TEST_F(WorldPicture, APlanIsReadAsAPlanAndTakesNoLabels) {
  const Path world = Path(ROOMATLAS_SOURCE_DIR) / "data" / "worlds" / "two_rooms.geojson";
  EXPECT_EQ(to_geojson(read_world(world, {})), to_geojson(read_plan(world)));
  EXPECT_THAT(message_of<UsageError>(world, {0.0, "rooms.pgm"}), HasSubstr("belong to a picture"));
}

struct RoomMap {
  const char* name;
  std::size_t rooms;
  std::size_t closed_off;  ///< rooms that no free pixel joins to the others
};

void PrintTo(const RoomMap& map, std::ostream* out) { *out << map.name; }

class SharedRoomMap : public testing::TestWithParam<RoomMap> {};

INSTANTIATE_TEST_SUITE_P(Rooms, SharedRoomMap,
                         testing::Values(RoomMap{"Freiburg79_scan", 18, 2}, RoomMap{"NLB", 56, 0},
                                         RoomMap{"office_g", 36, 0}),
                         [](const auto& map) { return map.param.name; });

TEST_P(SharedRoomMap, HasItsRoomsAndDoorsToAllThatAreNotClosedOff) {
  const std::string stem = std::string("rooms/") + GetParam().name + "/" + GetParam().name;
  const auto map = test::shared_data(stem + ".pgm.gz");
  const auto labels = test::shared_data(stem + "_gt_labels.pgm.gz");
  if (!map || !labels) return;
  const auto start = std::chrono::steady_clock::now();
  const FloorPlan world = read_world(*map, {0.05, *labels});
  const std::chrono::duration<double> time_s = std::chrono::steady_clock::now() - start;
  EXPECT_LT(time_s.count(), 10.0);
  EXPECT_EQ(world.rooms.size(), GetParam().rooms);
  std::size_t with_door = 0;
  for (const PlanRoom& room : world.rooms) {
    EXPECT_FALSE(is_in(world.walls, room.label_point)) << "room " << room.id;
    with_door += std::any_of(world.doors.begin(), world.doors.end(), [&](const PlanDoor& door) {
      return door.room_a == room.id || door.room_b == room.id;
    });
  }
  EXPECT_EQ(with_door + GetParam().closed_off, world.rooms.size());
}

TEST(SharedNavMap, IsReadWithItsPackedPictureAtItsOrigin) {
  const auto yaml = test::shared_data("floorplans/navmaps/kth.yaml");
  if (!yaml) return;
  const FloorPlan world = read_world(*yaml, {});
  Box2 box;
  for (const Polygon& wall : world.walls) {
    for (const Point2& corner : wall.outer) box.extend(corner);
  }
  EXPECT_GE(box.min.x(), -7.06);
  EXPECT_GE(box.min.y(), -17.56);
  EXPECT_LE(box.max.x(), -7.0 + 260 * 0.05 + 0.06);
  EXPECT_LE(box.max.y(), -17.5 + 781 * 0.05 + 0.06);
  EXPECT_GT(box.size().y(), 20.0);
}

TEST(SharedStageBitmaps, AreReadAsPng) {
  for (const char* name : {"autolab", "hospital_section", "sal2"}) {
    const auto file = test::shared_data(std::string("floorplans/stage/") + name + ".png");
    if (!file) return;
    EXPECT_FALSE(read_world(*file, {0.05, {}}).walls.empty()) << name;
  }
}

}  // namespace
}  // namespace roomatlas
