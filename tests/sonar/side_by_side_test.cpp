// SPDX-License-Identifier: GPL-3.0-or-later
// The batch where a wall lies nearer to another one than to itself.
#include <gtest/gtest.h>

#include <algorithm>

#include "../../src/sonar/sonar_batch.hpp"
#include "support/sonar_world.hpp"

namespace roomatlas {
namespace {

/// A robot goes round two corridors that lie side by side, three times; odometry is right, but the
/// poses to start from drift aside in the last round, so that the second corridor's walls come to
/// lie nearer to the first's.
struct SideBySide {
  SonarBatch batch;
  std::vector<Pose2> truth;
};

SideBySide side_by_side() {
  constexpr double kStepM = 0.4;
  constexpr double kBetweenM = 2.2;
  constexpr double kToWallM = 0.9;
  constexpr double kAsideM = 1.3;
  constexpr double kDriftM = 20.0;
  SideBySide mission;
  double drifted_m = 0.0;
  const std::vector<Pose2> round =
      test::drive_along({{0, 0}, {20, 0}, {20, kBetweenM}, {0, kBetweenM}, {0, 0}}, kStepM, kPi);
  for (int lap = 0; lap < 3; ++lap) {
    for (const Pose2& at : round) {
      const std::size_t k = mission.truth.size();
      const Pose2 pose{at.x_m, at.y_m, 0.0};  // it drives sideways and backwards, too
      const Pose2 before = k > 0 ? mission.truth.back() : pose;
      const bool is_in_second = pose.y_m > kBetweenM - 0.1;
      mission.truth.push_back(pose);
      SonarBatch& batch = mission.batch;
      const double aside_m = lap == 2 ? kAsideM * std::min(1.0, drifted_m / kDriftM) : 0.0;
      if (lap == 2) drifted_m += kStepM;
      batch.map_from_node.push_back({pose.x_m, pose.y_m - aside_m, 0.0});
      batch.steps.push_back({inverse(before) * pose, 0.02, 0.02, 0.01});
      if (!is_in_second && pose.y_m > 0.1) continue;
      const double corridor_m = is_in_second ? kBetweenM : 0.0;
      for (const double side : {-1.0, 1.0}) {
        const double across_m = corridor_m + side * kToWallM - pose.y_m;
        batch.walls.push_back(
            {k, side * kPi / 2.0, {0.0, across_m}, 1.0, kStepM * static_cast<double>(k)});
      }
    }
  }
  return mission;
}

TEST(SonarBatch, DoesNotTakeACorridorForTheOneBesideIt) {
  const SideBySide mission = side_by_side();
  const auto largest_m = [&](const SonarBatchOptions& options) {
    const SonarBatchResult result = solve_sonar_batch(mission.batch, options);
    double largest = 0.0;
    for (std::size_t k = 0; k < mission.truth.size(); ++k) {
      largest = std::max(largest,
                         (result.map_from_node[k].position() - mission.truth[k].position()).norm());
    }
    return largest;
  };
  EXPECT_LT(largest_m({}), 0.02);
  SonarBatchOptions at_once;
  at_once.start_wall_weight = at_once.wall_weight;
  EXPECT_GT(largest_m(at_once), 1.5);
}

}  // namespace
}  // namespace roomatlas
