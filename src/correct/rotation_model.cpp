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
  headings.reserve(poses.size());
  for (const Pose2& pose : poses) headings.push_back(pose.theta_rad);
  return headings;
}

/// The least-squares problem of the headings. Ceres knows them by their addresses: they stay put.
class RotationProblem {
 public:
  RotationProblem(const Measurements& measurements, const PlacedAsrs& start,
                  const CorrectOptions& options)
      : measurements_(measurements),
        start_(start),
        options_(options),
        headings_(headings_of(start.building_from_asr)),
        directions_(start.direction_rad),
        into_(edges_into(measurements)) {
    for (double& heading : headings_) problem_.AddParameterBlock(&heading, 1);
    for (const auto& edge : measurements.driven) add_heading(edge, FactorKind::odometry, nullptr);
    for (const auto& edge : measurements.recognised) {
      add_heading(edge, kind_of(edge.measured), robust());
      add_loop(edge);
    }
    for (std::size_t i = 0; i < headings_.size(); ++i) add_walls(i);
    for (std::size_t i = 0; i < headings_.size(); ++i) {
      if (measurements.is_fixed[i]) problem_.SetParameterBlockConstant(&headings_[i]);
    }
  }

  ModelResult solve() {
    report_before();
    ModelResult result;
    roomatlas::solve(problem_, factors_, options_, result);
    result.state = {poses_of(measurements_, headings_), directions_};
    return result;
  }

 private:
  [[nodiscard]] ceres::LossFunction* robust() const {
    return new ceres::CauchyLoss(options_.robust_sigmas);
  }

  void add_heading(const Measurements::Edge& edge, FactorKind kind, ceres::LossFunction* loss) {
    auto* cost = new RelativeHeadingFactor(edge.measured.from_from_to.theta_rad,
                                           sigmas_of(edge.measured, options_).heading_rad);
    const auto block =
        problem_.AddResidualBlock(cost, loss, &headings_[edge.from], &headings_[edge.to]);
    factors_.push_back({block, report_of(measurements_, edge, kind), loss != nullptr});
  }

  /// The steps from pivot to pivot lead to where the edge says; nothing where no chain leads there.
  void add_loop(const Measurements::Edge& edge) {
    const auto chain = chain_between(into_, edge.from, edge.to);
    if (chain.empty()) return;
    std::vector<Point2> steps_m;
    std::vector<double*> along;
    double variance_m2 = position_variance_m2(edge.measured);
    for (const Measurements::Edge* step : chain) {
      steps_m.push_back(step->measured.from_from_to.position());
      along.push_back(&headings_[step->from]);
      const double sigma_m = sigmas_of(step->measured, options_).position_m;
      variance_m2 += sigma_m * sigma_m;
    }
    steps_m.front() -= edge.measured.from_from_to.position();
    const auto block = problem_.AddResidualBlock(
        new PivotLoopFactor(std::move(steps_m), std::sqrt(variance_m2)), robust(), along);
    factors_.push_back({block, report_of(measurements_, edge, kind_of(edge.measured)), true});
  }

  void add_walls(std::size_t i) {
    const auto offset = wall_offset(measurements_, start_, i, options_);
    if (!offset) return;
    const auto component = static_cast<std::size_t>(measurements_.component[i]);
    const auto block = problem_.AddResidualBlock(
        new WallDirectionFactor<1>(*offset, wall_sigma_rad(*measurements_.walls[i], options_)),
        robust(), &headings_[i], &directions_[component]);
    FactorReport report;
    report.kind = FactorKind::wall_direction;
    report.from = measurements_.ids[i];
    factors_.push_back({block, report, true});
  }

  /// Chi-square of each factor at odometry's headings.
  void report_before() {
    const std::vector<double> at_start = headings_;
    std::ranges::copy(headings_of(measurements_.odom_from_asr), headings_.begin());
    for (ReportedFactor& factor : factors_) {
      factor.report.chi_square_before = chi_square(problem_, factor);
    }
    std::ranges::copy(at_start, headings_.begin());
  }

  const Measurements& measurements_;
  const PlacedAsrs& start_;
  const CorrectOptions& options_;
  std::vector<double> headings_;
  std::vector<double> directions_;
  std::vector<const Measurements::Edge*> into_;
  ceres::Problem problem_;
  std::vector<ReportedFactor> factors_;
};

}  // namespace

ModelResult solve_rotation_only(const Measurements& measurements, const PlacedAsrs& start,
                                const CorrectOptions& options) {
  return RotationProblem(measurements, start, options).solve();
}

}  // namespace roomatlas
