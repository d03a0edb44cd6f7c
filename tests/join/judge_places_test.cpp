// SPDX-License-Identifier: GPL-3.0-or-later
// Rooms that look alike to walls, told from each other by single rays.
#include "roomatlas/join/judge_places.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/drawn_shape.hpp"

namespace roomatlas {
namespace {

using namespace test;

constexpr double kApartM = 6.0;  // from a room's corner to the next one's

/// Three rooms alike; in the last one a cupboard stands in another corner.
struct Building {
  std::vector<DrawnWall> walls;
  SeenBuilding seen;
  Building() {
    std::vector<Point2> places;
    for (int room = 0; room < 3; ++room) {
      const double x = room * kApartM;
      for (const DrawnWall& wall : room_walls(x, 0.0, 5.0, 4.0, 0.0)) walls.push_back(wall);
      const double cupboard_x = room == 2 ? x + 4.2 : x;
      for (const DrawnWall& wall : room_walls(cupboard_x, 0.0, 0.8, 0.5, 0.0)) {
        walls.push_back(wall);
      }
      for (const Point2& at : {Point2{1.5, 1.5}, Point2{3.5, 1.5}, Point2{2.5, 2.8}}) {
        places.push_back(at + Point2{x, 0.0});
      }
    }
    const AsrShape shape = seen_shape(1, walls, places, {});
    const AsrShape* one = &shape;
    seen.add(sketch_of({&one, 1}, {{1, Pose2{}}}));
  }
};

AskedVisit asked_in(const Building& building, int room) {
  AskedVisit visit;
  visit.id = 5;
  for (const Point2& in_room : {Point2{2.0, 2.0}, Point2{2.6, 2.0}, Point2{3.2, 2.2}}) {
    const Point2 from = in_room + Point2{room * kApartM, 0.0};
    for (int n = 0; n < 60; ++n) {
      const double heading_rad = radians(6.0 * n);
      const double range_m = range_to(building.walls, from, direction(heading_rad)).value_or(30.0);
      visit.rays.push_back({{in_room.x(), in_room.y(), heading_rad}, range_m, 0.0, true});
    }
  }
  return visit;
}

/// Places in each of the rooms, all of the same score by walls.
std::vector<MissionPlace> in_all_rooms() {
  std::vector<MissionPlace> places;
  for (int room = 0; room < 3; ++room) {
    MissionPlace place;
    place.building_from_mission = {room * kApartM, 0.0, 0.0};
    place.score = 40.0;
    PlacedPiece piece;
    piece.visits = {5};
    piece.place.building_from_query = place.building_from_mission;
    place.pieces = {piece};
    places.push_back(place);
  }
  return places;
}

JudgedPlaces judged(const Building& building, int room, std::vector<MissionPlace> places) {
  return judge_places(std::move(places), {asked_in(building, room)}, building.seen,
                      SensorKind::laser, {});
}

TEST(JudgePlaces, PutsFirstWhereTheRaysWereMeasured) {
  const Building building;
  const JudgedPlaces result = judged(building, 2, in_all_rooms());
  ASSERT_EQ(result.places.size(), 3U);
  EXPECT_DOUBLE_EQ(result.places[0].building_from_mission.x_m, 2 * kApartM);
  EXPECT_GT(result.places[0].score, result.places[1].score + 0.5);
}

TEST(JudgePlaces, IsSurerOfARoomThatDiffersThanOfRoomsAlike) {
  const Building building;
  const JudgedPlaces alike = judged(building, 0, in_all_rooms());
  const JudgedPlaces other = judged(building, 2, in_all_rooms());
  EXPECT_LT(alike.first_is_right, 0.5);  // one of two that nothing tells apart
  EXPECT_GT(other.first_is_right, 3.0 * alike.first_is_right);
}

TEST(JudgePlaces, GivesTheSameWhateverOrderEqualPlacesComeIn) {
  const Building building;
  const JudgedPlaces first = judged(building, 2, in_all_rooms());
  std::vector<MissionPlace> places = in_all_rooms();
  std::reverse(places.begin(), places.end());
  const JudgedPlaces second = judged(building, 2, places);
  EXPECT_DOUBLE_EQ(first.first_is_right, second.first_is_right);
  EXPECT_DOUBLE_EQ(first.places[0].score, second.places[0].score);
}

TEST(JudgePlaces, AsksNoPlaceThatWallsPutFarBehind) {
  const Building building;
  std::vector<MissionPlace> places = in_all_rooms();
  places[2].score = 5.0;
  const JudgedPlaces result = judged(building, 2, places);
  EXPECT_DOUBLE_EQ(result.places[2].score, 5.0);
  EXPECT_DOUBLE_EQ(result.places[2].building_from_mission.x_m, 2 * kApartM);
}

TEST(JudgePlaces, HasNothingToSayWithoutPlaces) {
  const Building building;
  const JudgedPlaces result = judged(building, 0, {});
  EXPECT_TRUE(result.places.empty());
  EXPECT_EQ(result.first_is_right, 0.0);
}

}  // namespace
}  // namespace roomatlas
