// SPDX-License-Identifier: GPL-3.0-or-later
#include <ceres/loss_function.h>

#include <Eigen/LU>

#include <algorithm>

#include "ceres_model.hpp"
#include "factors.hpp"

namespace roomatlas {
namespace {

/// The driven edge that leads into each ASR from an earlier one, if any.
std::vector<const Measurements::Edge*> edges_into(const Measurements& measurements) {
  std::vector<const Measurements::Edge*> into(measurements.ids.size(), nullptr);
  for (const Measurements::Edge& edge : measurements.driven) {
    if (edge.from < edge.to) into[edge.to] = &edge;
  }
  return into;
}

/// The driven edges from one ASR to a later one, in order; empty when no chain leads there.
std::vector<const Measurements::Edge*> chain_between(
    const std::vector<const Measurements::Edge*>& into, std::size_t from, std::size_t to) {
  std::vector<const Measurements::Edge*> chain;
  for (std::size_t at = to; at != from; at = chain.back()->from) {
    if (into[at] == nullptr) return {};
    chain.push_back(into[at]);
  }
  std::reverse(chain.begin(), chain.end());
  return chain;
}

/// Variance of a coordinate of where a matched edge puts `to`, in the mean over all directions;
/// none for a doorway, whose two sides are one place.
double position_variance_m2(const PassageEdge& edge) {
  if (edge.source != EdgeSource::matched) return 0.0;
  return edge.information.inverse().topLeftCorner<2, 2>().trace() / 2.0;
}

/// Positions follow from the pivots: each ASR begins where the one before puts its exit.
std::vector<Pose2> poses_of(const Measurements& measurements, const std::vector<double>& headings) {
  const auto into = edges_into(measurements);
  std::vector<Pose2> poses = measurements.odom_from_asr;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (into[i] != nullptr) {
      const Point2 pivot = poses[into[i]->from] * into[i]->measured.from_from_to.position();
      poses[i].x_m = pivot.x();
      poses[i].y_m = pivot.y();
    }
    poses[i].theta_rad = wrap_angle(headings[i]);
  }
  return poses;
}

std::vector<double> headings_of(const std::vector<Pose2>& poses) {
  std::vector<double> headings;
  for (const Pose2& pose : poses) headings.push_back(pose.theta_rad);
  return headings;
}

}  // namespace

ModelResult solve_rotation_only(const Measurements& measurements, const State& start,
                                const CorrectOptions& options) {
  std::vector<double> headings = headings_of(start.building_from_asr);
  std::vector<double> directions = start.direction_rad;
  const auto into = edges_into(measurements);
  ceres::Problem problem;
  std::vector<ReportedFactor> factors;
  const auto robust = [&] { return new ceres::CauchyLoss(options.robust_sigmas); };

  for (double& heading : headings) problem.AddParameterBlock(&heading, 1);
  const auto add_heading = [&](const Measurements::Edge& edge, FactorKind kind, bool is_robust) {
    auto* cost = new RelativeHeadingFactor(edge.measured.from_from_to.theta_rad,
                                           sigmas_of(edge.measured, options).heading_rad);
    const auto block = problem.AddResidualBlock(cost, is_robust ? robust() : nullptr,
                                                &headings[edge.from], &headings[edge.to]);
    factors.push_back({block, report_of(measurements, edge, kind), is_robust});
  };
  for (const auto& edge : measurements.driven) add_heading(edge, FactorKind::odometry, false);
  for (const auto& edge : measurements.recognised) {
    add_heading(edge, kind_of(edge.measured), true);
    const auto chain = chain_between(into, edge.from, edge.to);
    if (chain.empty()) continue;
    std::vector<Point2> steps_m;
    std::vector<double*> along;
    double variance_m2 = position_variance_m2(edge.measured);
    for (const Measurements::Edge* step : chain) {
      steps_m.push_back(step->measured.from_from_to.position());
      along.push_back(&headings[step->from]);
      const double sigma_m = sigmas_of(step->measured, options).position_m;
      variance_m2 += sigma_m * sigma_m;
    }
    steps_m.front() -= edge.measured.from_from_to.position();
    const auto block = problem.AddResidualBlock(
        new PivotLoopFactor(std::move(steps_m), std::sqrt(variance_m2)), robust(), along);
    factors.push_back({block, report_of(measurements, edge, kind_of(edge.measured)), true});
  }
  for (std::size_t i = 0; i < headings.size(); ++i) {
    const auto offset = wall_offset(measurements, start, i, options);
    if (!offset) continue;
    const auto component = static_cast<std::size_t>(measurements.component[i]);
    const auto block = problem.AddResidualBlock(
        new WallDirectionFactor<1>(*offset, wall_sigma_rad(*measurements.walls[i], options)),
        robust(), &headings[i], &directions[component]);
    FactorReport report;
    report.kind = FactorKind::wall_direction;
    report.from = measurements.ids[i];
    factors.push_back({block, report, true});
  }
  for (std::size_t i = 0; i < headings.size(); ++i) {
    if (measurements.is_fixed[i]) problem.SetParameterBlockConstant(&headings[i]);
  }

  // Values change in place: Ceres knows the parameters by their addresses.
  const std::vector<double> at_start = headings;
  std::ranges::copy(headings_of(measurements.odom_from_asr), headings.begin());
  for (ReportedFactor& factor : factors) {
    factor.report.chi_square_before = chi_square(problem, factor);
  }
  std::ranges::copy(at_start, headings.begin());

  ModelResult result;
  solve(problem, factors, options, result);
  result.state = {poses_of(measurements, headings), directions};
  return result;
}

}  // namespace roomatlas
