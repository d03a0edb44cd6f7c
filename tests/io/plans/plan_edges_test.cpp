// SPDX-License-Identifier: GPL-3.0-or-later
// What speaks for the edges of rooms, in plan.local.geojson.
#include "draw/flat_fixture.hpp"
#include "io/plan_file.hpp"
#include "roomatlas/core/issue.hpp"

#include <gmock/gmock.h>

namespace roomatlas {
namespace {

using testing::HasSubstr;
using testing_io::collection;
using testing_io::read_plan_text;

const std::string kRoom =
    R"({"type":"Feature","properties":{"kind":"room","id":1},"geometry":{"type":"Polygon",)"
    R"("coordinates":[[[0,0],[4,0],[4,3],[0,0]]]}})";

std::string edge(const std::string& properties, const std::string& ends) {
  return kRoom + R"(,{"type":"Feature","properties":{"kind":"edge",)" + properties +
         R"(},"geometry":{"type":"LineString","coordinates":)" + ends + "}}";
}

std::string refusal(const std::string& features) {
  try {
    (void)read_plan_text(collection(features));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(PlanEdges, ReadBackWithTheirRoomEvidenceAndDeviation) {
  const FloorPlan plan = test::flat();
  const FloorPlan read = read_plan_text(to_geojson(plan));
  ASSERT_EQ(read.edges.size(), plan.edges.size());
  for (std::size_t i = 0; i < plan.edges.size(); ++i) {
    EXPECT_EQ(read.edges[i].room, plan.edges[i].room);
    EXPECT_EQ(read.edges[i].evidence, plan.edges[i].evidence);
    EXPECT_EQ(read.edges[i].deviation_m, plan.edges[i].deviation_m);
    EXPECT_LT((read.edges[i].line.a - plan.edges[i].line.a).norm(), 1e-3);
    EXPECT_LT((read.edges[i].line.b - plan.edges[i].line.b).norm(), 1e-3);
  }
}

TEST(PlanEdges, AFileWithoutThemHasNone) {
  EXPECT_TRUE(read_plan_text(collection(kRoom)).edges.empty());
  EXPECT_THAT(to_geojson(read_plan_text(collection(kRoom))),
              testing::Not(HasSubstr(R"("kind":"edge")")));
}

TEST(PlanEdges, OneThatRoundingLeavesNoLengthIsLeftOut) {
  FloorPlan plan = test::flat();
  plan.edges = {{1, {{1, 1}, {1.0001, 1}}, WallEvidence::measured, std::nullopt}};
  EXPECT_TRUE(read_plan_text(to_geojson(plan)).edges.empty());
}

TEST(PlanEdges, WhatIsNotRightIsNamed) {
  const std::string ends = "[[0,0],[4,0]]";
  EXPECT_EQ(refusal(edge(R"("room":1,"evidence":"inferred")", ends)), "no error");
  EXPECT_THAT(refusal(edge(R"("room":1,"evidence":"guessed")", ends)),
              HasSubstr("features[1].properties.evidence: expected \"measured\""));
  EXPECT_THAT(refusal(edge(R"("evidence":"inferred")", ends)), HasSubstr("room: missing"));
  EXPECT_THAT(refusal(edge(R"("room":2,"evidence":"inferred")", ends)),
              HasSubstr("an edge is of room 2, which is not in the file"));
  EXPECT_THAT(refusal(edge(R"("room":1,"evidence":"inferred")", "[[0,0],[4,0],[4,3]]")),
              HasSubstr("expected two positions"));
  EXPECT_THAT(refusal(edge(R"("room":1,"evidence":"measured","deviation_m":-1)", ends)),
              HasSubstr("deviation_m"));
}

}  // namespace
}  // namespace roomatlas
