// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/graph/recognise.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/chain_mission.hpp"

namespace roomatlas {
namespace {

using test::chain_mission;
using test::pose_deg;
using test::rectangle;
using test::round_the_block;
using test::true_placement;
using test::Visit;

const Ring kHall = rectangle(0, 0, 12, 3);
const Ring kLeftRoom = rectangle(0, 3, 5, 8);
const Ring kRightRoom = rectangle(5, 3, 12, 8);

std::vector<PassageEdge> recognised(const std::vector<Visit>& visits,
                                    const RecogniseOptions& options = {}) {
  return recognise_doorways(chain_mission(visits), true_placement(visits), options);
}

TEST(RecogniseDoorways, FindsOneGoneThroughAgainTheSameWay) {
  const auto edges = recognised(round_the_block(0.0));
  ASSERT_EQ(edges.size(), 1u);
  EXPECT_EQ(edges[0].from, 2);
  EXPECT_EQ(edges[0].to, 6);
  EXPECT_EQ(edges[0].from_from_to, Pose2{});
  EXPECT_EQ(edges[0].source, EdgeSource::recognised);
  EXPECT_EQ(edges[0].path_length_m, 0.0);
}

TEST(RecogniseDoorways, FindsOneGoneBackThroughAsHalfATurn) {
  const auto edges = recognised(
      {{kHall, pose_deg(1, 1, 0)}, {kLeftRoom, pose_deg(4, 3, 90)}, {kHall, pose_deg(4, 3, -90)}});
  ASSERT_EQ(edges.size(), 1u);
  EXPECT_EQ(edges[0].from, 2);
  EXPECT_EQ(edges[0].to, 3);
  EXPECT_EQ(edges[0].from_from_to.position(), Point2::Zero());
  EXPECT_NEAR(std::abs(edges[0].from_from_to.theta_rad), kPi, 1e-12);
}

TEST(RecogniseDoorways, MeasuresWhatATruePlacementShows) {
  const std::vector<Visit> visits = {{kHall, pose_deg(1, 1, 0)},   {kLeftRoom, pose_deg(4, 3, 90)},
                                     {kHall, pose_deg(4, 3, -90)}, {kRightRoom, pose_deg(8, 3, 90)},
                                     {kHall, pose_deg(8, 3, -90)}, {kLeftRoom, pose_deg(4, 3, 90)}};
  const auto truth = true_placement(visits);
  const auto edges = recognised(visits);
  ASSERT_EQ(edges.size(), 3u);
  for (const PassageEdge& edge : edges) {
    const Pose2 expected = inverse(truth.at(edge.from)) * truth.at(edge.to);
    EXPECT_LT((edge.from_from_to.position() - expected.position()).norm(), 1e-9);
    EXPECT_NEAR(wrap_angle(edge.from_from_to.theta_rad - expected.theta_rad), 0.0, 1e-9);
  }
}

TEST(RecogniseDoorways, DoesNotConfuseTwoDoorsTwoMetresApart) {
  EXPECT_TRUE(recognised({{kHall, pose_deg(1, 1, 0)},
                          {kLeftRoom, pose_deg(4, 3, 90)},
                          {kHall, pose_deg(6, 3, -90)},
                          {kRightRoom, pose_deg(8, 3, 90)}})
                  .empty());
}

TEST(RecogniseDoorways, DoesNotConfuseDoorsAtRightAngles) {
  EXPECT_TRUE(recognised({{kHall, pose_deg(1, 1, 0)},
                          {kLeftRoom, pose_deg(4.8, 3, 90)},
                          {kRightRoom, pose_deg(5, 3, 0)}})
                  .empty());
}

TEST(RecogniseDoorways, DoesNotConfuseDoorsOfOtherWidths) {
  RecogniseOptions options;
  options.max_width_difference_m = 0.3;
  const auto edges_with = [&](double width_m) {
    return recognised({{kHall, pose_deg(1, 1, 0)},
                       {kLeftRoom, pose_deg(4, 3, 90), 0.0, 0.8},
                       {kHall, pose_deg(4, 3, -90), 0.0, width_m}},
                      options);
  };
  EXPECT_EQ(edges_with(1.0).size(), 1u);
  EXPECT_EQ(edges_with(1.2).size(), 0u);
}

TEST(RecogniseDoorways, LeavesOpenPassagesAndDoorsToNowhereAlone) {
  std::vector<Visit> visits = {{kHall, pose_deg(1, 1, 0)},
                               {kLeftRoom, pose_deg(4, 3, 90), 0.0, 0.0},
                               {kHall, pose_deg(4, 3, -90), 0.0, 0.0}};
  EXPECT_TRUE(recognised(visits).empty());
  visits[1].width_m = visits[2].width_m = 0.9;
  EXPECT_FALSE(recognised(visits).empty());
  visits[2].is_linked = false;
  EXPECT_TRUE(recognised(visits).empty());
  EXPECT_TRUE(recognise_doorways({}, {}, {}).empty());
}

TEST(RecogniseDoorways, MatchesTheNearestOfSeveralEarlierCrossings) {
  const std::vector<Visit> visits = {{kHall, pose_deg(1, 1, 0)},
                                     {kLeftRoom, pose_deg(4, 3, 90)},
                                     {kHall, pose_deg(4.8, 3, -90)},
                                     {kRightRoom, pose_deg(4.7, 3, 90)}};
  RecogniseOptions options;
  options.gate_m = 0.75;
  options.gate_growth = 0.0;
  const auto edges = recognised(visits, options);
  ASSERT_EQ(edges.size(), 1u);
  EXPECT_EQ(edges[0].from, 3);
  EXPECT_EQ(edges[0].to, 4);
}

/// Into a room, on to another far away, and back where odometry sees the first door 0.7 m beside.
std::vector<PassageEdge> after_a_way_of(double way_m, const RecogniseOptions& options) {
  const std::vector<Visit> visits = {{kHall, pose_deg(1, 1, 0)},
                                     {kLeftRoom, pose_deg(4, 3, 90)},
                                     {kRightRoom, pose_deg(4 + way_m / 2, 3, 90)},
                                     {kHall, pose_deg(4, 3, -90)}};
  Placement placement = true_placement(visits);
  placement.at(4).x_m += 0.7;
  return recognise_doorways(chain_mission(visits), placement, options);
}

TEST(RecogniseDoorways, ItsGateGrowsWithTheWayDrivenInBetween) {
  RecogniseOptions options;
  options.gate_m = 0.4;
  options.gate_growth = 0.01;
  options.max_gate_m = 1.0;
  EXPECT_EQ(after_a_way_of(20.0, options).size(), 0u);  // gate 0.6 m
  EXPECT_EQ(after_a_way_of(28.0, options).size(), 0u);  // 0.68 m
  EXPECT_EQ(after_a_way_of(32.0, options).size(), 1u);  // 0.72 m
  options.max_gate_m = 0.6;
  EXPECT_EQ(after_a_way_of(1000.0, options).size(), 0u);
}

}  // namespace
}  // namespace roomatlas
