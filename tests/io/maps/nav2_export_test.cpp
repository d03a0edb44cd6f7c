// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/maps/nav2_export.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "io/store/store_samples.hpp"
#include "roomatlas/io/maps/read_world.hpp"

namespace roomatlas {
namespace {

/// Two rooms of 3 m x 2 m with a wall of 0.02 m between them and a door of 0.9 m in it.
FloorPlan thin_wall() {
  const auto box = [](double x0, double y0, double x1, double y1) {
    return Polygon{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
  };
  FloorPlan plan;
  plan.rooms = {{1, "1", RoomKind::room, {box(0, 0, 3, 2)}, 6.0, {1, 1}, {}},
                {2, "2", RoomKind::room, {box(3.02, 0, 6.02, 2)}, 6.0, {5, 1}, {}}};
  Polygon outer = box(-0.15, -0.15, 6.17, 2.15);
  outer.holes = {box(0, 0, 6.02, 2).outer};
  plan.walls = {outer, box(3, 0, 3.02, 0.53), box(3, 1.43, 3.02, 2)};
  plan.doors = {{1,
                 {{3.01, 0.53}, {3.01, 1.43}},
                 0.9,
                 box(3, 0.53, 3.02, 1.43).outer,
                 1,
                 2,
                 DoorKind::door,
                 {}}};
  return plan;
}

struct Pgm {
  int width = 0;
  int height = 0;
  std::string pixels;
  [[nodiscard]] int at(int x, int y) const {  // y from below
    return static_cast<unsigned char>(
        pixels.at(static_cast<std::size_t>((height - 1 - y) * width + x)));
  }
};

Pgm pgm_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  Pgm pgm;
  std::string magic;
  int white = 0;
  stream >> magic >> pgm.width >> pgm.height >> white;
  stream.get();
  pgm.pixels.assign(std::istreambuf_iterator<char>(stream), {});
  EXPECT_EQ(magic, "P5");
  return pgm;
}

TEST(Nav2Map, WallsWithoutBreadthDoNotShutADoor) {
  FloorPlan plan = thin_wall();
  plan.walls.push_back({{{3.02, 0.53}, {3.021, 0.53}, {3.021, 1.43}, {3.02, 1.43}}, {}});
  const TemporaryDirectory folder;
  write_nav2_map(folder / ".", plan);
  const Pgm map = pgm_of(folder / "map.pgm");
  const int row = static_cast<int>((0.98 + 0.65) / 0.05);  // through the door's middle
  for (int x = 15; x < 130; ++x) EXPECT_EQ(map.at(x, row), 254) << x;
}

TEST(Nav2Map, IsFreeInRoomsOccupiedInWallsAndUnknownOutside) {
  const TemporaryDirectory folder;
  write_nav2_map(folder / ".", thin_wall());
  const Pgm map = pgm_of(folder / "map.pgm");
  EXPECT_EQ(map.at(0, 0), 205);
  const auto free = std::count(map.pixels.begin(), map.pixels.end(), static_cast<char>(254));
  EXPECT_NEAR(static_cast<double>(free) * 0.05 * 0.05, 12.0, 0.8);
  // The lower left corner is at -0.15 - 0.5 m, which is 13 cells of 0.05 m.
  EXPECT_EQ(map.at(13 + 20, 13 + 20), 254);
  EXPECT_EQ(map.at(13 - 2, 13 + 20), 0);
}

TEST(Nav2Map, KeepsThinWallsClosedAndDoorsOpen) {
  const TemporaryDirectory folder;
  write_nav2_map(folder / ".", thin_wall());
  const Pgm map = pgm_of(folder / "map.pgm");
  int open_rows = 0;
  for (int y = 13; y < 13 + 40; ++y) {
    bool is_open = true;
    for (int x = 13 + 55; x < 13 + 66; ++x) is_open = is_open && map.at(x, y) == 254;
    if (is_open) ++open_rows;
  }
  EXPECT_NEAR(open_rows * 0.05, 0.9, 0.101);
}

TEST(Nav2Map, ReadsBackAsAWorldOfTheSameSize) {
  const TemporaryDirectory folder;
  write_nav2_map(folder / ".", thin_wall());
  const FloorPlan world = read_world(folder / "map.yaml", {});
  Box2 box;
  for (const Polygon& wall : world.walls) {
    for (const Point2& point : wall.outer) box.extend(point);
  }
  EXPECT_NEAR(box.min.x(), -0.15, 0.051);
  EXPECT_NEAR(box.max.x(), 6.17, 0.051);
  EXPECT_NEAR(box.max.y(), 2.15, 0.051);
}

TEST(Nav2Map, MaskKeepsOutOfAllThatIsNotFree) {
  const TemporaryDirectory folder;
  write_nav2_map(folder / ".", thin_wall());
  const Pgm map = pgm_of(folder / "map.pgm");
  const Pgm mask = pgm_of(folder / "keepout_mask.pgm");
  ASSERT_EQ(mask.pixels.size(), map.pixels.size());
  for (std::size_t i = 0; i < map.pixels.size(); ++i) {
    const bool is_free = map.pixels[i] == static_cast<char>(254);
    ASSERT_EQ(static_cast<unsigned char>(mask.pixels[i]), is_free ? 254 : 0);
  }
}

TEST(Nav2Map, HasTheSameBytesHoweverManyRowsAreInMemory) {
  FloorPlan plan = thin_wall();
  plan.furniture = {{{{{1, 0.4}, {2, 0.6}, {1.6, 1.5}}, {}}, FurnitureKind::free_standing}};
  plan.walls.push_back({{{-3, -2}, {9, 5}, {9, 5.01}, {-3, -1.99}}, {}});
  const TemporaryDirectory whole;
  write_nav2_map(whole / ".", plan);
  for (const int cells : {1, 1000, 7777}) {
    const TemporaryDirectory folder;
    write_nav2_map(folder / ".", plan, {0.05, 0.5, cells});
    for (const char* name : {"map.pgm", "keepout_mask.pgm"}) {
      const Pgm expected = pgm_of(whole / name);
      const Pgm found = pgm_of(folder / name);
      EXPECT_EQ(found.width, expected.width);
      EXPECT_TRUE(found.pixels == expected.pixels) << name << " " << cells;
    }
  }
}

TEST(Nav2Map, OfAPlanThatIsTooLargeIsRefused) {
  const TemporaryDirectory folder;
  FloorPlan plan = thin_wall();
  EXPECT_TRUE(fits_nav2_map(plan));
  plan.rooms.push_back(plan.rooms.front());
  for (Point2& point : plan.rooms.back().parts.front().outer) point += Point2(9000.0, 9000.0);
  EXPECT_FALSE(fits_nav2_map(plan));
  EXPECT_THROW(write_nav2_map(folder / ".", plan), InputError);
  EXPECT_TRUE(std::filesystem::is_empty(folder / "."));
}

TEST(Nav2Map, OfAnEmptyPlanIsOneUnknownCell) {
  const TemporaryDirectory folder;
  write_nav2_map(folder / ".", {});
  EXPECT_EQ(pgm_of(folder / "map.pgm").pixels, std::string(1, static_cast<char>(205)));
}

}  // namespace
}  // namespace roomatlas
