// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/loops/visit_graph.hpp"

#include <gmock/gmock.h>

#include <Eigen/LU>
#include <cmath>

namespace roomatlas {
namespace {

/// Three visits in a row, 4 m apart, each driven into from the one before.
RoomGraph row_of_visits() {
  RoomGraph graph;
  for (AsrId id = 1; id <= 3; ++id) graph.vertices.push_back({id, id});
  for (AsrId id = 1; id <= 2; ++id) {
    PassageEdge edge;
    edge.from = id;
    edge.to = id + 1;
    edge.from_from_to = {4.0, 0.0, 0.0};
    edge.path_length_m = 4.0;
    add_edge(graph, edge);
  }
  return graph;
}

/// As the row lies, turned by 90 degrees.
Correction placed() {
  Correction correction;
  correction.model = "se2";
  correction.converged = true;
  for (AsrId id = 1; id <= 3; ++id) {
    AsrCorrection asr;
    asr.asr = id;
    asr.building_from_asr = {0.0, 4.0 * static_cast<double>(id - 1), kPi / 2.0};
    correction.asrs.push_back(asr);
  }
  return correction;
}

Closure closure(AsrId from, AsrId to, const Eigen::Matrix3d& information) {
  Closure closure;
  closure.from = from;
  closure.to = to;
  closure.match.first_from_second = {4.0 * static_cast<double>(to - from), 0.0, 0.0};
  closure.match.information = information;
  closure.verdict = ClosureVerdict::accepted;
  return closure;
}

RoomGraph with_match(RoomGraph graph, AsrId from, AsrId to) {
  PassageEdge edge;
  edge.from = from;
  edge.to = to;
  edge.from_from_to = {1.0, 1.0, 1.0};  // what the store's closure says counts instead
  edge.source = EdgeSource::matched;
  add_edge(graph, edge);
  return graph;
}

TEST(VisitGraph, MatchesOfWallsHaveTheInformationAndPoseOfTheStore) {
  const Eigen::Matrix3d information = Eigen::Vector3d(100.0, 200.0, 300.0).asDiagonal();
  const PoseGraph graph =
      pose_graph_of(with_match(row_of_visits(), 1, 3), {closure(1, 3, information)}, {});
  ASSERT_EQ(graph.edges.size(), 3U);
  EXPECT_EQ(graph.edges[2].information, information);
  EXPECT_DOUBLE_EQ(graph.edges[2].from_from_to.position().x(), 8.0);
  EXPECT_EQ(graph.edges[2].kind, EdgeKind::loop);
}

TEST(VisitGraph, MatchesWithoutInformationHaveNoEdge) {
  EXPECT_EQ(pose_graph_of(with_match(row_of_visits(), 1, 3), {}, {}).edges.size(), 2U);
}

TEST(VisitUncertainty, OfTheFirstStepIsThatOfItsMeasurementInBuildingAxes) {
  const RoomGraph graph = row_of_visits();
  const VisitUncertainty found = uncertainty_of(graph, {}, placed(), {});
  ASSERT_EQ(found.visits.size(), 2U);
  const Eigen::Matrix3d covariance = information_of(graph.edges[0], {}).inverse();
  EXPECT_EQ(found.visits[0].asr, 2);
  EXPECT_NEAR(found.visits[0].covariance_m2(0, 0), covariance(1, 1), 1e-9);  // turned by 90 deg
  EXPECT_NEAR(found.visits[0].covariance_m2(1, 1), covariance(0, 0), 1e-9);
  EXPECT_NEAR(found.visits[0].heading_sigma_rad, std::sqrt(covariance(2, 2)), 1e-9);
}

TEST(VisitUncertainty, GrowsAlongThePathAndAcrossItMostOfAll) {
  const VisitUncertainty found = uncertainty_of(row_of_visits(), {}, placed(), {});
  ASSERT_EQ(found.visits.size(), 2U);
  const auto& [near, far] = std::pair(found.visits[0], found.visits[1]);
  EXPECT_GT(far.covariance_m2.trace(), 2.0 * near.covariance_m2.trace());
  EXPECT_GT(far.covariance_m2(0, 0), far.covariance_m2(1, 1));  // the path runs along y
  EXPECT_NEAR(*found.typical_m,
              std::sqrt((near.covariance_m2.trace() + far.covariance_m2.trace()) / 4.0), 1e-12);
}

TEST(VisitUncertainty, ShrinksWithAMatchOfWalls) {
  const Eigen::Matrix3d information = Eigen::Vector3d(2500.0, 2500.0, 1e5).asDiagonal();
  const VisitUncertainty without = uncertainty_of(row_of_visits(), {}, placed(), {});
  const VisitUncertainty with =
      uncertainty_of(with_match(row_of_visits(), 1, 3), {closure(1, 3, information)}, placed(), {});
  ASSERT_EQ(with.visits.size(), 2U);
  EXPECT_LT(with.visits[1].covariance_m2.trace(), 2.0 / 2500.0);
  EXPECT_LT(*with.typical_m, *without.typical_m);
}

TEST(VisitUncertainty, TakesNoneOfAPassageThatTheCorrectionDidNotBelieve) {
  RoomGraph graph = row_of_visits();
  const Eigen::Matrix3d information = Eigen::Vector3d(2500.0, 2500.0, 1e5).asDiagonal();
  Closure elsewhere = closure(1, 3, information);
  elsewhere.match.first_from_second.x_m += 3.0;  // the robot was lost on the way to 3
  graph = with_match(std::move(graph), 1, 3);
  const VisitUncertainty believed = uncertainty_of(graph, {elsewhere}, placed(), {});
  Correction correction = placed();
  FactorReport lost;
  lost.from = 2;
  lost.to = 3;
  lost.weight = 1e-6;
  correction.factors.push_back(lost);
  const VisitUncertainty found = uncertainty_of(graph, {elsewhere}, correction, {});
  ASSERT_TRUE(found.typical_m && believed.typical_m);
  EXPECT_LT(*found.typical_m, 0.5 * *believed.typical_m);
}

TEST(VisitUncertainty, IsNotClaimedForAMissionThatWasCorrectedAsAWhole) {
  Correction correction = placed();
  correction.model = "trajectory";
  EXPECT_FALSE(uncertainty_of(row_of_visits(), {}, correction, {}).typical_m);
}

TEST(VisitUncertainty, OfNothingIsNothing) {
  EXPECT_TRUE(uncertainty_of({}, {}, {}, {}).visits.empty());
}

}  // namespace
}  // namespace roomatlas
