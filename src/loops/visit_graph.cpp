// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/loops/visit_graph.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

#include "roomatlas/solve/optimize.hpp"

namespace roomatlas {
namespace {

/// Both visits begin at the same doorway, in the same direction or in the opposite one.
Pose2 shared_doorway(const Pose2& placed) {
  return {0.0, 0.0, std::abs(placed.theta_rad) < kPi / 2.0 ? 0.0 : wrap_angle(kPi)};
}

/// The accepted matches of walls, by the visits that they join.
std::map<std::pair<AsrId, AsrId>, const MapMatch*> accepted_of(
    const std::vector<Closure>& closures) {
  std::map<std::pair<AsrId, AsrId>, const MapMatch*> accepted;
  for (const Closure& closure : closures) {
    if (closure.verdict != ClosureVerdict::accepted) continue;
    accepted.emplace(std::pair(closure.from, closure.to), &closure.match);
  }
  return accepted;
}

EdgeKind kind_of(EdgeSource source) {
  return source == EdgeSource::driven ? EdgeKind::odometry : EdgeKind::loop;
}

}  // namespace

PoseGraph pose_graph_of(const RoomGraph& graph, const std::vector<Closure>& closures,
                        const CorrectOptions& options) {
  const auto accepted = accepted_of(closures);
  PoseGraph result;
  std::map<AsrId, std::int32_t> index_of;
  for (std::size_t i = 0; i < graph.vertices.size(); ++i) {
    index_of[graph.vertices[i].asr] = static_cast<std::int32_t>(i);
    result.ids.push_back(graph.vertices[i].asr);
  }
  for (const PassageEdge& edge : graph.edges) {
    PoseEdge measured;
    measured.from = index_of.at(edge.from);
    measured.to = index_of.at(edge.to);
    measured.kind = kind_of(edge.source);
    measured.information = information_of(edge, options);
    measured.from_from_to = edge.source == EdgeSource::recognised
                                ? shared_doorway(edge.from_from_to)
                                : edge.from_from_to;
    const auto match = accepted.find({edge.from, edge.to});
    if (edge.source == EdgeSource::matched && match != accepted.end()) {
      measured.information = match->second->information;
      measured.from_from_to = match->second->first_from_second;
    }
    if (measured.information.isZero()) continue;
    result.edges.push_back(measured);
  }
  return result;
}

namespace {

constexpr const char* kByTrajectory = "trajectory";  // the model of a mission corrected as a whole

/// What the residuals say of the measurements' covariances: the variance factor of surveyors. Few
/// loops cannot show that measurements are better than stated.
double variance_factor(const OptimizeResult& solved) {
  constexpr std::int64_t kEnough = 20;  // degrees of freedom; with fewer a small factor is chance
  const std::int64_t degrees_of_freedom = solved.expected.degrees_of_freedom;
  if (degrees_of_freedom <= 0) return 1.0;
  const double factor = solved.chi_square / static_cast<double>(degrees_of_freedom);
  return degrees_of_freedom < kEnough ? std::max(1.0, factor) : factor;
}

/// The directions of walls that the correction used, each as sure as 10 m of wall make it.
void add_wall_directions(const Correction& correction, const CorrectOptions& options,
                         PoseGraph& graph) {
  constexpr double kWall_m = 10.0;  // for every room, since a report does not tell its length
  constexpr double kUsed = 0.5;     // weight of a factor that counts
  const double sigma_deg =
      std::hypot(options.wall_heading_deg, options.wall_heading_deg_m / kWall_m);
  std::map<AsrId, std::int32_t> index_of;
  for (std::size_t i = 0; i < graph.ids.size(); ++i) {
    index_of[graph.ids[i]] = static_cast<std::int32_t>(i);
  }
  for (const FactorReport& factor : correction.factors) {
    if (factor.kind != FactorKind::wall_direction || factor.weight < kUsed) continue;
    HeadingPrior heading;
    heading.node = index_of.at(factor.from);
    heading.theta_rad = graph.guess[static_cast<std::size_t>(heading.node)].theta_rad;
    heading.sigma_rad = radians(sigma_deg);
    graph.headings.push_back(heading);
  }
}

/// Passages in which the robot was lost count as little as the correction believed them.
void weigh_passages(const Correction& correction, PoseGraph& graph) {
  std::map<std::pair<AsrId, AsrId>, double> weight_of;
  for (const FactorReport& factor : correction.factors) {
    if (factor.kind == FactorKind::odometry) weight_of[{factor.from, factor.to}] = factor.weight;
  }
  for (PoseEdge& edge : graph.edges) {
    if (edge.kind != EdgeKind::odometry) continue;
    const auto weight = weight_of.find({graph.ids[static_cast<std::size_t>(edge.from)],
                                        graph.ids[static_cast<std::size_t>(edge.to)]});
    if (weight != weight_of.end()) edge.information *= weight->second;
  }
}

/// The frames of the components' covariances, as turns from building axes: that of the fixed node,
/// or building axes themselves where headings hold the component.
std::vector<double> frames_of(const PoseGraph& graph, const OptimizeResult& solved) {
  std::vector<double> theta_rad;
  for (const std::int32_t fixed : solved.fixed) {
    theta_rad.push_back(graph.guess[static_cast<std::size_t>(fixed)].theta_rad);
  }
  for (const HeadingPrior& heading : graph.headings) {
    const std::int32_t component = solved.component[static_cast<std::size_t>(heading.node)];
    theta_rad[static_cast<std::size_t>(component)] = 0.0;
  }
  return theta_rad;
}

Eigen::Matrix2d in_building(const Eigen::Matrix3d& covariance, double frame_rad) {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(frame_rad).toRotationMatrix();
  return turn * covariance.topLeftCorner<2, 2>() * turn.transpose();
}

}  // namespace

HeldVisits held_visits_of(const RoomGraph& graph, const std::vector<Closure>& closures,
                          const Correction& correction, const CorrectOptions& options) {
  HeldVisits held{pose_graph_of(graph, closures, options), 1.0};
  const Placement placement = placement_of(correction);
  for (const AsrId id : held.measured.ids) held.measured.guess.push_back(placement.at(id));
  if (correction.model != kByTrajectory && !held.measured.edges.empty()) {
    weigh_passages(correction, held.measured);
    for (PoseEdge& edge : held.measured.edges) {
      if (edge.kind == EdgeKind::loop) edge.cauchy_sigmas = options.robust_sigmas;
    }
    held.variance_factor = variance_factor(optimize(held.measured, {}));
  }
  add_wall_directions(correction, options, held.measured);
  return held;
}

VisitUncertainty uncertainty_of(const RoomGraph& graph, const std::vector<Closure>& closures,
                                const Correction& correction, const CorrectOptions& options) {
  if (correction.model == kByTrajectory) return {};
  const auto [measured, factor] = held_visits_of(graph, closures, correction, options);
  if (measured.edges.empty()) return {};
  OptimizeOptions wanted;
  wanted.covariance = true;
  const OptimizeResult solved = optimize(measured, wanted);
  const std::vector<double> frame_rad = frames_of(measured, solved);
  VisitUncertainty uncertainty;
  uncertainty.variance_factor = factor;
  double sum_m2 = 0.0;
  for (std::size_t i = 0; i < measured.ids.size(); ++i) {
    const auto component = static_cast<std::size_t>(solved.component[i]);
    if (static_cast<std::size_t>(solved.fixed[component]) == i) continue;
    const Pose2& at = measured.guess[i];
    const Eigen::Matrix3d& covariance = solved.covariance.of_node[i];
    uncertainty.visits.push_back({measured.ids[i], at.position(),
                                  factor * in_building(covariance, frame_rad[component]),
                                  std::sqrt(factor * covariance(2, 2))});
    sum_m2 += uncertainty.visits.back().covariance_m2.trace() / 2.0;
  }
  if (!uncertainty.visits.empty()) {
    uncertainty.typical_m = std::sqrt(sum_m2 / static_cast<double>(uncertainty.visits.size()));
  }
  return uncertainty;
}

}  // namespace roomatlas
