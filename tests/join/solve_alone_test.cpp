// SPDX-License-Identifier: GPL-3.0-or-later
// One mission moved against what stays, beside all solved together.
#include <gtest/gtest.h>

#include <cmath>

#include "joint_graph.hpp"

namespace roomatlas {
namespace {

MissionMap chain(AsrId first, int visits) {
  MissionMap mission;
  for (int i = 0; i < visits; ++i) {
    AsrShape shape;
    shape.id = first + i;
    mission.shapes.push_back(std::move(shape));
    mission.mission_from_asr[first + i] = {3.0 * i, 0.1 * i, 0.05 * i};
  }
  return mission;
}

Closure match(AsrId from, AsrId to, const Pose2& first_from_second) {
  Closure closure;
  closure.from = from;
  closure.to = to;
  closure.match.first_from_second = first_from_second;
  closure.match.information = Eigen::Matrix3d::Identity() * 1e4;
  closure.verdict = ClosureVerdict::accepted;
  return closure;
}

class SolveAlone : public ::testing::Test {
 protected:
  /// The building lies somewhere turned; the mission where it belongs, but for `off`.
  SolveAlone() {
    for (const auto& [id, pose] : building_.mission_from_asr) placement_[id] = at_ * pose;
    for (const auto& [id, pose] : mission_.mission_from_asr) {
      truth_[id] = at_ * Pose2{0.4, 1.0, 0.3} * pose;
      placement_[id] = truth_.at(id) * Pose2{0.2, -0.1, 0.02};
    }
  }

  Closure true_match(AsrId from, AsrId to) const {
    return match(from, to, inverse(placement_.at(from)) * truth_.at(to));
  }

  MissionMap building_ = chain(1, 5);
  MissionMap mission_ = chain(11, 4);
  Pose2 at_{7.0, -3.0, 1.1};
  Placement placement_;
  Placement truth_;
};

TEST_F(SolveAlone, PutsTheMissionWhereItsMatchesSayAndLeavesTheBuilding) {
  const Placement before = placement_;
  std::vector<Closure> closures = {true_match(1, 11), true_match(4, 13)};
  EXPECT_TRUE(solve_alone(mission_, {}, placement_, closures));
  for (const auto& [id, pose] : building_.mission_from_asr) {
    EXPECT_EQ(placement_.at(id), before.at(id));
  }
  for (const auto& [id, pose] : truth_) {
    EXPECT_LT((placement_.at(id).position() - pose.position()).norm(), 1e-4) << id;
    EXPECT_LT(std::abs(wrap_angle(placement_.at(id).theta_rad - pose.theta_rad)), 1e-4) << id;
  }
  // Where all agree, nothing is left to gain by moving the building.
  Placement together = placement_;
  solve_joint({&building_, &mission_}, {}, together, closures);
  for (const auto& [id, pose] : together) {
    const Pose2 one = inverse(together.at(1)) * pose;
    const Pose2 other = inverse(placement_.at(1)) * placement_.at(id);
    EXPECT_LT((one.position() - other.position()).norm(), 1e-3) << id;
  }
}

TEST_F(SolveAlone, SaysWhereAMatchContradictsTheOthers) {
  std::vector<Closure> closures = {true_match(1, 11), true_match(2, 12), true_match(4, 13),
                                   match(5, 14, {4.0, 3.0, 1.0})};
  EXPECT_FALSE(solve_alone(mission_, {}, placement_, closures));
  EXPECT_EQ(closures[3].verdict, ClosureVerdict::contradicted);
  EXPECT_EQ(closures[0].verdict, ClosureVerdict::accepted);
  EXPECT_LT((placement_.at(12).position() - truth_.at(12).position()).norm(), 0.05);
}

TEST_F(SolveAlone, LeavesAMissionWithoutMatchesWhereItWasFound) {
  const Placement before = placement_;
  std::vector<Closure> closures;
  EXPECT_TRUE(solve_alone(mission_, {}, placement_, closures));
  EXPECT_EQ(placement_, before);
}

}  // namespace
}  // namespace roomatlas
