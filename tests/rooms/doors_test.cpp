// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/rooms/doors.hpp"

#include <gmock/gmock.h>

#include "support/chain_mission.hpp"

namespace roomatlas {
namespace {

using test::chain_mission;
using test::pose_deg;
using test::rectangle;
using test::true_placement;
using test::Visit;
using testing::ElementsAre;

const Ring kHall = rectangle(0, 0, 12, 3);
const Ring kRoom = rectangle(0, 3, 12, 8);
const std::map<AsrId, RoomId> kHallAndRoom = {{1, 1}, {2, 2}, {3, 1}, {4, 2}};

/// Hall, room, hall and room again, through doorways at x = 4.0, 4.1 and the given one.
std::vector<Visit> in_and_out(double last_x_m) {
  return {{kHall, pose_deg(1, 1, 0)},
          {kRoom, pose_deg(4.0, 3, 91), 0.0, 0.8},
          {kHall, pose_deg(4.1, 3, -91), 0.0, 1.0},
          {kRoom, pose_deg(last_x_m, 3, 93), 0.0, 0.9}};
}

std::vector<Door> doors(const std::vector<Visit>& visits, const std::map<AsrId, RoomId>& rooms,
                        const std::vector<PassageEdge>& recognised = {}) {
  const auto asrs = chain_mission(visits);
  RoomGraph graph = build_graph(asrs);
  for (const PassageEdge& edge : recognised) add_edge(graph, edge);
  return doors_of(asrs, graph, true_placement(visits), rooms);
}

TEST(Doors, CrossingsOfOneDoorwayGiveOneDoorTheirAverage) {
  const auto found = doors(in_and_out(4.2), kHallAndRoom);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].room_a, 1);
  EXPECT_EQ(found[0].room_b, 2);
  EXPECT_THAT(found[0].crossings, ElementsAre(2, 3, 4));
  EXPECT_NEAR(found[0].width_m, 0.9, 1e-12);  // the median of 0.8, 1.0 and 0.9
  EXPECT_NEAR(found[0].frame_from_pivot.x_m, 4.1, 1e-9);
  EXPECT_NEAR(found[0].frame_from_pivot.y_m, 3.0, 1e-9);
  // the way back counts turned about: 91, -91 + 180 = 89 and 93 degrees
  EXPECT_NEAR(degrees(found[0].frame_from_pivot.theta_rad), 91.0, 0.1);
}

TEST(Doors, TwoDoorsBetweenTheSameRoomsStayTwo) {
  const auto found = doors(in_and_out(7.0), kHallAndRoom);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_THAT(found[0].crossings, ElementsAre(2, 3));
  EXPECT_THAT(found[1].crossings, ElementsAre(4));
  EXPECT_NEAR(found[1].frame_from_pivot.x_m, 7.0, 1e-9);
}

TEST(Doors, CrossingsThatTheGraphRecognisesAreOneHoweverFarApart) {
  const auto found = doors(in_and_out(5.5), kHallAndRoom, {test::same_doorway(2, 4)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0].crossings, ElementsAre(2, 3, 4));
}

TEST(Doors, LeadTheWayOfTheirFirstCrossing) {
  const std::vector<Visit> visits = {
      {kRoom, pose_deg(1, 5, 0)}, {kHall, pose_deg(4, 3, -90)}, {kRoom, pose_deg(4, 3, 90)}};
  const auto found = doors(visits, {{1, 1}, {2, 2}, {3, 1}});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].room_a, 1);
  EXPECT_EQ(found[0].room_b, 2);
  EXPECT_NEAR(degrees(found[0].frame_from_pivot.theta_rad), -90.0, 1e-9);
}

TEST(Doors, AnOpeningWithinOneRoomIsNone) {
  EXPECT_TRUE(doors(in_and_out(4.2), {{1, 1}, {2, 1}, {3, 1}, {4, 1}}).empty());
}

TEST(Doors, OpenPassagesAndExitsToNowhereAreNone) {
  auto open = in_and_out(4.2);
  for (Visit& visit : open) visit.width_m = 0.0;
  EXPECT_TRUE(doors(open, kHallAndRoom).empty());
  auto nowhere = in_and_out(4.2);
  for (Visit& visit : nowhere) visit.is_linked = false;
  EXPECT_TRUE(doors(nowhere, kHallAndRoom).empty());
  EXPECT_TRUE(doors({}, {}).empty());
}

TEST(Doors, ADoorwayIntoAThirdRoomIsAnotherDoorHoweverNear) {
  const auto found = doors(in_and_out(4.2), {{1, 1}, {2, 2}, {3, 1}, {4, 3}});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[1].room_b, 3);
}

TEST(Doors, AroundTheBlockThereAreFour) {
  const auto found =
      doors(test::round_the_block(0.0), {{1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 1}, {6, 2}});
  ASSERT_EQ(found.size(), 4u);
  EXPECT_THAT(found[0].crossings, ElementsAre(2, 6));
  EXPECT_THAT(found[1].crossings, ElementsAre(3));
  EXPECT_THAT(found[2].crossings, ElementsAre(4));
  EXPECT_THAT(found[3].crossings, ElementsAre(5));
  EXPECT_EQ(found[3].room_a, 4);
  EXPECT_EQ(found[3].room_b, 1);
}

TEST(Doors, JambsLieLeftAndRightOfTheDoorsDirection) {
  const Segment2 jambs = doorway_at(pose_deg(4, 3, 90), 1.0).jambs;
  EXPECT_LT((jambs.a - Point2(3.5, 3)).norm(), 1e-12);
  EXPECT_LT((jambs.b - Point2(4.5, 3)).norm(), 1e-12);
}

}  // namespace
}  // namespace roomatlas
