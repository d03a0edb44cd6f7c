// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of drawn buildings, found from nothing.
#include "roomatlas/locate/building_index.hpp"

#include <gtest/gtest.h>

#include "support/drawn_shape.hpp"

namespace roomatlas {
namespace {

using namespace test;

/// Three rooms of different sizes in a row, each with a box in a corner; `alike`: all the same.
struct Building {
  std::vector<DrawnWall> walls;
  std::vector<Point2> middles;
};

Building three_rooms(bool alike) {
  Building building;
  const double width[] = {4.0, 5.3, 7.1};
  const double height[] = {3.4, 4.6, 3.9};
  double x = 0.0;
  for (int room = 0; room < 3; ++room) {
    const double w = alike ? 5.0 : width[room];
    const double h = alike ? 4.0 : height[room];
    for (const DrawnWall& wall : room_walls(x, 0.0, w, h, alike ? 1.0 : 0.8 + 0.3 * room)) {
      building.walls.push_back(wall);
    }
    building.middles.push_back({x + w * 0.6, h * 0.6});
    x += w + 0.2;
  }
  return building;
}

FloorSketch sketched(const AsrShape& shape) {
  const AsrShape* one = &shape;
  return sketch_of({&one, 1}, {{shape.id, Pose2{}}});
}

/// The whole of it in building metres.
FloorSketch known(const Building& building) {
  return sketched(seen_shape(1, building.walls, building.middles, {}));
}

/// What a robot sees of one room, in a frame of its own.
FloorSketch query_in(const Building& building, std::size_t room, const Pose2& query_from_world) {
  const Point2 at = building.middles[room] + Point2{-0.3, 0.2};
  return sketched(seen_shape(2, building.walls, {at}, query_from_world));
}

TEST(BuildingIndex, FindsEachRoomHoweverItsFrameIsTurned) {
  const Building building = three_rooms(false);
  const BuildingIndex index(known(building), {});
  for (std::size_t room = 0; room < 3; ++room) {
    for (const double turn_deg : {0.0, 37.0, 110.0, -155.0}) {
      const Pose2 query_from_world{12.0, -3.0, radians(turn_deg)};
      const auto places = index.find(query_in(building, room, query_from_world));
      ASSERT_FALSE(places.empty());
      const Pose2 off = places[0].building_from_query * query_from_world;
      EXPECT_LT(off.position().norm(), 0.05) << "room " << room << " turned " << turn_deg;
      EXPECT_LT(std::abs(degrees(off.theta_rad)), 0.5);
      EXPECT_GT(places[0].agreement(), 0.95);
      if (places.size() < 2) continue;
      EXPECT_GT(places[0].score - places[1].score, 3.0);
    }
  }
}

TEST(BuildingIndex, SaysThatRoomsAlikeAreAlike) {
  const Building building = three_rooms(true);
  const BuildingIndex index(known(building), {});
  const auto places = index.find(query_in(building, 1, {}));
  ASSERT_GE(places.size(), 3U);  // one in each room
  EXPECT_LT(places[0].score - places[2].score, 0.15 * places[0].score);
}

TEST(BuildingIndex, FitsNothingOfAnotherBuildingWell) {
  const BuildingIndex index(known(three_rooms(false)), {});
  Building other;
  other.walls = room_walls(0.0, 0.0, 9.0, 6.0, 2.5);
  other.middles = {{5.0, 3.5}};
  const FloorSketch query = query_in(other, 0, {});
  for (const PlaceHypothesis& place : index.find(query)) {
    // Mostly beyond what is known all may agree; where much is known it does not.
    const bool is_known = 2 * place.unseen < static_cast<int>(query.walls.size());
    EXPECT_LT(place.agreement(), is_known ? 0.8 : 1.01);
    EXPECT_LT(place.agreeing, static_cast<int>(0.7 * static_cast<double>(query.walls.size())));
  }
}

TEST(BuildingIndex, TakesInWhatIsAddedAndGivesTheSameForAnyNumberOfJobs) {
  const Building building = three_rooms(false);
  const Building first{building.walls, {building.middles[0], building.middles[1]}};
  BuildingIndex index(known(first), {});
  const FloorSketch query = query_in(building, 2, {1.0, 2.0, 0.3});
  const auto before = index.find(query);
  index.add(sketched(seen_shape(3, building.walls, {building.middles[2]}, {})));
  const auto after = index.find(query, 1);
  ASSERT_FALSE(after.empty());
  EXPECT_GT(after[0].agreement(), 0.95);
  EXPECT_LT(before.empty() ? 0.0 : before[0].score, 0.8 * after[0].score);
  const auto again = index.find(query, 3);
  ASSERT_EQ(after.size(), again.size());
  for (std::size_t i = 0; i < after.size(); ++i) {
    EXPECT_EQ(after[i].building_from_query, again[i].building_from_query);
  }
}

TEST(BuildingIndex, FindsNothingForAQueryWithoutWalls) {
  const BuildingIndex index(known(three_rooms(false)), {});
  EXPECT_TRUE(index.find({}).empty());
}

}  // namespace
}  // namespace roomatlas
