// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/simulate/random_world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/simulate/world.hpp"

namespace roomatlas {
namespace {

constexpr double kCellM = 0.05;  // finer than the thinnest wall

/// The building as cells: a second way to ask what is where.
class Raster {
 public:
  explicit Raster(const FloorPlan& world) {
    for (const PlanRoom& room : world.rooms) {
      for (const Point2& corner : room.parts.front().outer) box_.extend(corner);
    }
    box_.extend(box_.min - Point2::Constant(1.0));
    box_.extend(box_.max + Point2::Constant(1.0));
    columns_ = static_cast<int>(box_.size().x() / kCellM) + 1;
    rows_ = static_cast<int>(box_.size().y() / kCellM) + 1;
    std::vector<Box2> bounds_of_walls;
    for (const Polygon& wall : world.walls) bounds_of_walls.push_back(bounds(wall.outer));
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        const Point2 at = middle(row, column);
        bool is_wall = false;
        for (std::size_t i = 0; i < world.walls.size() && !is_wall; ++i) {
          const Box2& box = bounds_of_walls[i];
          is_wall = (at.array() >= box.min.array()).all() &&
                    (at.array() <= box.max.array()).all() && contains(world.walls[i], at);
        }
        walls_.push_back(is_wall);
      }
    }
  }

  [[nodiscard]] bool is_wall(const Point2& at) const { return walls_[index_of(at)]; }

  /// All cells that a point of no size gets to.
  [[nodiscard]] std::vector<bool> reached_from(const Point2& start) const {
    std::vector<bool> reached(walls_.size(), false);
    std::vector<std::size_t> open = {index_of(start)};
    reached[open.front()] = true;
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      const int row = static_cast<int>(at) / columns_;
      const int column = static_cast<int>(at) % columns_;
      for (const auto& [to_row, to_column] :
           {std::pair(row + 1, column), std::pair(row - 1, column), std::pair(row, column + 1),
            std::pair(row, column - 1)}) {
        if (to_row < 0 || to_row >= rows_ || to_column < 0 || to_column >= columns_) continue;
        const auto next = static_cast<std::size_t>(to_row * columns_ + to_column);
        if (walls_[next] || reached[next]) continue;
        reached[next] = true;
        open.push_back(next);
      }
    }
    return reached;
  }

  [[nodiscard]] std::size_t index_of(const Point2& at) const {
    const int row = static_cast<int>((at.y() - box_.min.y()) / kCellM);
    const int column = static_cast<int>((at.x() - box_.min.x()) / kCellM);
    return static_cast<std::size_t>(row * columns_ + column);
  }
  [[nodiscard]] Point2 middle(int row, int column) const {
    return box_.min + kCellM * Point2(column + 0.5, row + 0.5);
  }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int columns() const { return columns_; }

 private:
  Box2 box_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<bool> walls_;
};

std::string text_of(const Issues& issues) {
  std::string text;
  for (const Issue& issue : issues) text += to_string(issue) + "\n";
  return text;
}

/// Rooms that a walk from door to door gets to.
std::set<RoomId> joined_to_the_first(const FloorPlan& world) {
  std::set<RoomId> found = {world.rooms.front().id};
  for (bool grows = true; grows;) {
    grows = false;
    for (const PlanDoor& door : world.doors) {
      if (found.contains(*door.room_a) == found.contains(*door.room_b)) continue;
      found.insert({*door.room_a, *door.room_b});
      grows = true;
    }
  }
  return found;
}

class RandomWorld : public testing::TestWithParam<int> {
 protected:
  [[nodiscard]] static RandomWorldOptions options(std::uint64_t seed) {
    return {seed, static_cast<RandomWorldKind>(GetParam()), 0};
  }
};

TEST_P(RandomWorld, HasNothingWrongForAnySeed) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    EXPECT_EQ(text_of(check_world(random_world(options(seed)))), "") << "seed " << seed;
  }
}

TEST_P(RandomWorld, KeepsItsPromisesOfSize) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const FloorPlan world = random_world(options(seed));
    EXPECT_GE(world.rooms.size(), 3U) << "seed " << seed;
    EXPECT_LE(world.rooms.size(), 45U) << "seed " << seed;
    for (const PlanRoom& room : world.rooms) {
      const Polygon& outline = room.parts.front();
      double clear_m = distance_to_boundary(outline.outer, room.label_point);
      for (const Ring& hole : outline.holes) {
        clear_m = std::min(clear_m, distance_to_boundary(hole, room.label_point));
      }
      EXPECT_GE(2.0 * clear_m, 1.4) << "seed " << seed << " room " << room.id;
      EXPECT_NEAR(room.area_m2, area(outline), 1e-6);
    }
    for (const PlanDoor& door : world.doors) {
      EXPECT_GE(door.width_m, 0.749) << "seed " << seed;
      EXPECT_LE(door.width_m, 1.601) << "seed " << seed;
      EXPECT_NEAR((door.jambs.a - door.jambs.b).norm(), door.width_m, 1e-6);
    }
  }
}

TEST_P(RandomWorld, ARasterOfItIsOneSpaceWithEveryRoomAndNoWayOut) {
  for (std::uint64_t seed = 100; seed < 105; ++seed) {
    const FloorPlan world = random_world(options(seed));
    EXPECT_EQ(joined_to_the_first(world).size(), world.rooms.size()) << "seed " << seed;
    const Raster raster(world);
    const auto free_start =
        std::find_if(world.rooms.begin(), world.rooms.end(),
                     [&](const PlanRoom& room) { return !raster.is_wall(room.label_point); });
    ASSERT_NE(free_start, world.rooms.end());
    const std::vector<bool> reached = raster.reached_from(free_start->label_point);
    EXPECT_FALSE(reached.front()) << "seed " << seed << ": there is a hole in the outer wall";
    std::map<RoomId, double> reached_m2;
    for (int row = 0; row < raster.rows(); ++row) {
      for (int column = 0; column < raster.columns(); ++column) {
        const Point2 at = raster.middle(row, column);
        if (!reached[raster.index_of(at)]) continue;
        int holders = 0;
        for (const PlanRoom& room : world.rooms) {
          if (!contains(room.parts.front(), at)) continue;
          ++holders;
          reached_m2[room.id] += kCellM * kCellM;
        }
        EXPECT_LE(holders, 1) << "seed " << seed << ": rooms overlap";
      }
    }
    for (const PlanRoom& room : world.rooms) {
      EXPECT_GT(reached_m2[room.id], 0.8 * room.area_m2) << "seed " << seed << " room " << room.id;
    }
  }
}

TEST_P(RandomWorld, IsTheSameForTheSameSeedAndAnotherForAnother) {
  EXPECT_EQ(to_geojson(random_world(options(7))), to_geojson(random_world(options(7))));
  EXPECT_NE(to_geojson(random_world(options(7))), to_geojson(random_world(options(8))));
}

INSTANTIATE_TEST_SUITE_P(AllKinds, RandomWorld, testing::Range(0, kRandomWorldKinds),
                         [](const auto& kind) {
                           return std::string(to_string(static_cast<RandomWorldKind>(kind.param)));
                         });

TEST(RandomWorlds, OfSeedsAloneAreOfAllKinds) {
  std::set<RandomWorldKind> kinds;
  for (std::uint64_t seed = 0; seed < 100; ++seed) kinds.insert(kind_of({seed, {}, 0}));
  EXPECT_EQ(kinds.size(), static_cast<std::size_t>(kRandomWorldKinds));
}

TEST(RandomWorlds, HaveAboutSoManyRoomsAsAskedFor) {
  for (std::uint64_t seed = 1; seed < 20; ++seed) {
    const auto rooms = random_world({seed, RandomWorldKind::offices, 12}).rooms.size();
    EXPECT_EQ(rooms, 12U) << "seed " << seed;
  }
  EXPECT_THROW((void)random_world({1, {}, 2}), UsageError);
  EXPECT_THROW((void)random_world({1, {}, 41}), UsageError);
}

TEST(RandomWorlds, WingsMeetAtOddAngles) {
  int odd = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const FloorPlan world = random_world({seed, RandomWorldKind::wings, 0});
    std::vector<double> ways_rad;
    for (const PlanRoom& room : world.rooms) {
      if (room.kind != RoomKind::corridor) continue;
      const Ring& ring = room.parts.front().outer;
      const Point2 side = ring[1] - ring[0];
      ways_rad.push_back(std::atan2(side.y(), side.x()));
    }
    ASSERT_GE(ways_rad.size(), 2U);
    const double bend_deg = std::abs(degrees(wrap_quarter(ways_rad[1] - ways_rad[0])));
    if (bend_deg > 3.0) ++odd;
  }
  EXPECT_GE(odd, 15);
}

}  // namespace
}  // namespace roomatlas
