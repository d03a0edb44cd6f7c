// SPDX-License-Identifier: GPL-3.0-or-later
#include <ceres/cost_function.h>
#include <ceres/loss_function.h>

#include <algorithm>
#include <array>
#include <optional>

#include "ceres_model.hpp"
#include "factors.hpp"
#include "roomatlas/solve/relative_pose_cost.hpp"

namespace roomatlas {
namespace {

using PoseBlock = std::array<double, 3>;

std::vector<PoseBlock> blocks_of(const std::vector<Pose2>& poses) {
  std::vector<PoseBlock> blocks;
  blocks.reserve(poses.size());
  for (const Pose2& pose : poses) blocks.push_back({pose.x_m, pose.y_m, pose.theta_rad});
  return blocks;
}

}  // namespace

ModelResult solve_se2(const Measurements& measurements, const PlacedAsrs& start,
                      const CorrectOptions& options) {
  std::vector<PoseBlock> poses = blocks_of(start.building_from_asr);
  std::vector<double> directions = start.direction_rad;
  ceres::Problem problem;
  std::vector<ReportedFactor> factors;

  for (PoseBlock& pose : poses) problem.AddParameterBlock(pose.data(), 3);
  const auto add_edge = [&](const Measurements::Edge& edge, FactorKind kind,
                            std::optional<double> robust_sigmas) {
    auto* cost =
        relative_pose_cost(edge.measured.from_from_to, information_of(edge.measured, options))
            .release();
    auto* loss = robust_sigmas ? new ceres::CauchyLoss(*robust_sigmas) : nullptr;
    const auto block =
        problem.AddResidualBlock(cost, loss, poses[edge.from].data(), poses[edge.to].data());
    factors.push_back({block, report_of(measurements, edge, kind), loss != nullptr});
  };
  for (const auto& edge : measurements.driven) {
    add_edge(
        edge, FactorKind::odometry,
        edge.measured.is_doubtful ? std::optional(options.passage_robust_sigmas) : std::nullopt);
  }
  for (const auto& edge : measurements.recognised) {
    add_edge(edge, kind_of(edge.measured), options.robust_sigmas);
  }
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const auto offset = wall_offset(measurements, start, i, options);
    if (!offset) continue;
    const auto component = static_cast<std::size_t>(measurements.component[i]);
    const auto block = problem.AddResidualBlock(
        new WallDirectionFactor<3>(*offset, wall_sigma_rad(*measurements.walls[i], options)),
        new ceres::CauchyLoss(options.robust_sigmas), poses[i].data(), &directions[component]);
    FactorReport report;
    report.kind = FactorKind::wall_direction;
    report.from = measurements.ids[i];
    factors.push_back({block, report, true});
  }
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (measurements.is_fixed[i]) problem.SetParameterBlockConstant(poses[i].data());
  }

  // Values change in place: Ceres knows the parameters by their addresses.
  const std::vector<PoseBlock> at_start = poses;
  std::ranges::copy(blocks_of(measurements.odom_from_asr), poses.begin());
  for (ReportedFactor& factor : factors) {
    factor.report.chi_square_before = chi_square(problem, factor);
  }
  std::ranges::copy(at_start, poses.begin());

  ModelResult result;
  solve(problem, factors, options, result);
  for (const PoseBlock& pose : poses) {
    result.state.building_from_asr.push_back({pose[0], pose[1], wrap_angle(pose[2])});
  }
  result.state.direction_rad = directions;
  return result;
}

}  // namespace roomatlas
