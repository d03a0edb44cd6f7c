// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/room_tables.hpp"

#include <gmock/gmock.h>

namespace roomatlas {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

FloorPlan two_rooms() {
  FloorPlan plan;
  plan.rooms = {
      {1, "Lab \"A\", west", RoomKind::room, {{{{0, 0}, {4, 0}, {4, 3}}, {}}}, 12.346, {1, 1}, {}},
      {2, "R&D <2>", RoomKind::corridor, {}, 5.0, {6, 1}, {}}};
  plan.doors = {{1, {{4, 1}, {4, 2}}, 1.0, {}, 1, 2},
                {2, {{0, 1}, {0, 1.9}}, 0.9, {}, 1, std::nullopt}};
  return plan;
}

TEST(RoomsCsv, QuotesNamesAndCountsDoors) {
  EXPECT_EQ(rooms_csv(two_rooms()),
            "id,name,kind,area_m2,doors\r\n"
            "1,\"Lab \"\"A\"\", west\",room,12.35,2\r\n"
            "2,R&D <2>,corridor,5.00,1\r\n");
}

TEST(RoomsCsv, OfAnEmptyPlanHasItsHeaderAlone) {
  EXPECT_EQ(rooms_csv({}), "id,name,kind,area_m2,doors\r\n");
}

TEST(RoomsGraphml, HasRoomsAsNodesAndDoorsBetweenTwoRoomsAsEdges) {
  const std::string text = rooms_graphml(two_rooms());
  EXPECT_THAT(text, HasSubstr("<node id=\"r2\"><data key=\"name\">R&amp;D &lt;2&gt;</data>"));
  EXPECT_THAT(text, HasSubstr("<edge id=\"d1\" source=\"r1\" target=\"r2\">"
                              "<data key=\"width_m\">1.000</data></edge>"));
  EXPECT_THAT(text, Not(HasSubstr("id=\"d2\"")));
}

TEST(RoomsYaml, NamesRoomsDoorsAndGoals) {
  const std::string text = rooms_yaml(two_rooms());
  EXPECT_THAT(text, HasSubstr("name: \"Lab \\\"A\\\", west\"\n"));
  EXPECT_THAT(text, HasSubstr("goal: [1.0,1.0]\n"));
  EXPECT_THAT(text, HasSubstr("- [[0.0,0.0],[4.0,0.0],[4.0,3.0]]\n"));
  EXPECT_THAT(text, HasSubstr("rooms: [1, null]\n"));
}

}  // namespace
}  // namespace roomatlas
