// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "roomatlas/graph/recognise.hpp"
#include "roomatlas/rooms/assign_rooms.hpp"
#include "support/chain_mission.hpp"

namespace roomatlas {
namespace {

using test::chain_mission;
using test::pose_deg;
using test::rectangle;
using test::round_the_block;
using test::true_placement;
using test::Visit;
using testing::ElementsAre;
using testing::Pair;

const Ring kLeft = rectangle(0, 0, 5, 4);
const Ring kRight = rectangle(5, 0, 10, 4);

/// From one half into the other.
std::vector<Visit> two_spaces(double passage_width_m) {
  return {{kLeft, pose_deg(1, 2, 0)}, {kRight, pose_deg(5, 2, 0), 0.0, passage_width_m}};
}

std::map<AsrId, RoomId> rooms_of(const std::vector<Asr>& asrs, const std::vector<Visit>& visits,
                                 const std::vector<PassageEdge>& recognised = {}) {
  RoomGraph graph = build_graph(asrs);
  for (const PassageEdge& edge : recognised) add_edge(graph, edge);
  return assign_rooms(asrs, graph, true_placement(visits), {});
}

std::map<AsrId, RoomId> rooms_of(const std::vector<Visit>& visits) {
  return rooms_of(chain_mission(visits), visits);
}

/// Takes the walls through a doorway away, as if nobody had seen them.
void drop_walls_at(std::vector<WallPolyline>& walls, const Point2& pivot) {
  std::erase_if(walls, [&](const WallPolyline& wall) {
    return distance({wall.vertices_asr.front(), wall.vertices_asr.back()}, pivot) < 0.1;
  });
}

TEST(AssignRooms, ADoorwayWithWallBesideItSeparatesRooms) {
  EXPECT_THAT(rooms_of(two_spaces(0.9)), ElementsAre(Pair(1, 1), Pair(2, 2)));
}

TEST(AssignRooms, AnOpenPassageJoinsWhatItCut) {
  EXPECT_THAT(rooms_of(two_spaces(0.0)), ElementsAre(Pair(1, 1), Pair(2, 1)));
}

TEST(AssignRooms, AWallBesideTheDoorwaySeenFromOneSideAloneIsEnough) {
  const auto visits = two_spaces(0.9);
  auto from_left = chain_mission(visits);
  drop_walls_at(from_left[1].walls, Point2::Zero());
  EXPECT_THAT(rooms_of(from_left, visits), ElementsAre(Pair(1, 1), Pair(2, 2)));
  auto from_right = chain_mission(visits);
  drop_walls_at(from_right[0].walls, from_right[0].exits.back().frame_from_pivot.position());
  EXPECT_THAT(rooms_of(from_right, visits), ElementsAre(Pair(1, 1), Pair(2, 2)));
}

TEST(AssignRooms, AnOpeningWithoutWallBesideItDoesNotSeparate) {
  const auto visits = two_spaces(0.9);
  auto asrs = chain_mission(visits);
  drop_walls_at(asrs[0].walls, asrs[0].exits.back().frame_from_pivot.position());
  drop_walls_at(asrs[1].walls, Point2::Zero());
  EXPECT_THAT(rooms_of(asrs, visits), ElementsAre(Pair(1, 1), Pair(2, 1)));
  // wall beside one jamb alone is a cupboard's side
  asrs[1].walls.push_back({{{0.0, 0.45}, {0.0, 2.0}}, {true}});
  EXPECT_THAT(rooms_of(asrs, visits), ElementsAre(Pair(1, 1), Pair(2, 1)));
  asrs[1].walls.push_back({{{0.0, -0.45}, {0.0, -2.0}}, {true}});
  EXPECT_THAT(rooms_of(asrs, visits), ElementsAre(Pair(1, 1), Pair(2, 2)));
}

TEST(AssignRooms, RevisitsAreTheSameRoomByTheirOverlapAndNumberedByTheFirst) {
  EXPECT_THAT(rooms_of(round_the_block(0.0)),
              ElementsAre(Pair(1, 1), Pair(2, 2), Pair(3, 3), Pair(4, 4), Pair(5, 1), Pair(6, 2)));
}

TEST(AssignRooms, OverlapThatIsTooSmallJoinsNothing) {
  auto visits = two_spaces(0.9);
  auto asrs = chain_mission(visits);
  const auto reach_back_to = [&](double min_x) {
    asrs[1].outline_asr.outer =
        transformed(inverse(visits[1].entered_at), rectangle(min_x, 0, 10, 4));
  };
  reach_back_to(4.0);  // a fifth of the left room
  EXPECT_THAT(rooms_of(asrs, visits), ElementsAre(Pair(1, 1), Pair(2, 2)));
  reach_back_to(1.0);  // four fifths
  EXPECT_THAT(rooms_of(asrs, visits), ElementsAre(Pair(1, 1), Pair(2, 1)));
}

TEST(AssignRooms, ARecognisedDoorwayJoinsTheRoomsOnItsSidesWithoutAnyOutline) {
  // left, right, left, and right again
  const std::vector<Visit> visits = {{kLeft, pose_deg(1, 2, 0)},
                                     {kRight, pose_deg(5, 2, 0)},
                                     {kLeft, pose_deg(5, 2, 180)},
                                     {kRight, pose_deg(5, 2, 0)}};
  auto asrs = chain_mission(visits);
  for (Asr& asr : asrs) asr.outline_asr = {};
  EXPECT_THAT(rooms_of(asrs, visits), ElementsAre(Pair(1, 1), Pair(2, 2), Pair(3, 3), Pair(4, 4)));
  EXPECT_THAT(rooms_of(asrs, visits, {test::same_doorway(2, 3, -kPi)}),
              ElementsAre(Pair(1, 1), Pair(2, 2), Pair(3, 1), Pair(4, 3)));
  EXPECT_THAT(rooms_of(asrs, visits, {test::same_doorway(2, 4)}),
              ElementsAre(Pair(1, 1), Pair(2, 2), Pair(3, 1), Pair(4, 2)));
}

TEST(AssignRooms, JoinsAcrossSeveralStepsAndCountsWithoutGaps) {
  // an open hall in three pieces, then two rooms, then the hall's first piece again
  const std::vector<Visit> visits = {{rectangle(0, 0, 6, 4), pose_deg(1, 2, 0)},
                                     {rectangle(6, 0, 12, 4), pose_deg(6, 2, 0), 0.0, 0.0},
                                     {rectangle(12, 0, 18, 4), pose_deg(12, 2, 0), 0.0, 0.0},
                                     {rectangle(12, 4, 18, 9), pose_deg(15, 4, 90)},
                                     {rectangle(0, 4, 12, 9), pose_deg(12, 7, 180)},
                                     {rectangle(0, 0, 6, 4), pose_deg(3, 4, -90)}};
  EXPECT_THAT(rooms_of(visits),
              ElementsAre(Pair(1, 1), Pair(2, 1), Pair(3, 1), Pair(4, 2), Pair(5, 3), Pair(6, 1)));
}

TEST(AssignRooms, OfNoAsrsIsNothing) { EXPECT_TRUE(rooms_of(std::vector<Visit>{}).empty()); }

TEST(AssignRooms, DoesNotDependOnWhereTheBuildingLies) {
  const auto visits = round_the_block(0.0);
  const auto asrs = chain_mission(visits);
  Placement moved = true_placement(visits);
  for (auto& [id, pose] : moved) pose = pose_deg(100, -40, 33) * pose;
  EXPECT_EQ(assign_rooms(asrs, build_graph(asrs), moved, {}), rooms_of(asrs, visits));
}

}  // namespace
}  // namespace roomatlas
