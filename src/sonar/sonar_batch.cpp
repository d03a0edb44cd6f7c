// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_batch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "roomatlas/solve/block_cholesky.hpp"
#include "sonar_factors.hpp"

namespace roomatlas {
namespace {

/// How far each round's scale has gone from the start's to the end's, on a logarithmic scale.
constexpr std::array kShrunk = {0.0, 0.0,  0.0,  0.1, 0.1, 0.22, 0.22, 0.3, 0.3, 0.4,
                                0.4, 0.52, 0.52, 0.7, 0.7, 0.82, 0.92, 1.0, 1.0};
constexpr int kStepsARound = 3;       // more settle on pairs that the next round drops
constexpr double kFineScaleM = 0.15;  // below it walls count in full
constexpr double kFirmly = 1e6;   // weight that holds the first node: more than all walls together
constexpr double kStillM = 1e-4;  // root mean square of the moves at which a round ends
constexpr double kEndsM = radians(1.0);  // over a wall's length: sigma of its direction by its ends
constexpr double kFarSigmas = 2.0;  // from a direction: scale at which Geman and McClure let go

/// Which walls are one, and how much that counts.
struct Round {
  double scale_m = 0.0;      ///< across, at which Geman and McClure let go of a pair
  double wall_weight = 0.0;  ///< of a wall's partners together
  std::vector<WallPair> pairs;
  std::vector<int> partners;  ///< of each wall
};

/// What is solved for.
struct Unknowns {
  std::vector<Pose2> map_from_node;
  double length_scale = 1.0;
};

/// Normal equations of the nodes for one set of pairs, and of the one scale of all lengths. The
/// scale touches every node: it stands beside the sparse matrix, not in it.
class Equations {
 public:
  Equations(std::size_t nodes, const std::vector<NodePair>& pairs)
      : supernodes_(find_supernodes(nodes, pairs)), matrix_(supernodes_), nodes_(nodes) {}

  void clear() {
    matrix_.clear();
    right_side_.assign(3 * nodes_, 0.0);
    by_scale_.assign(3 * nodes_, 0.0);
    scale_weight_ = 0.0;
    scale_right_ = 0.0;
  }

  /// Adds weight times the square of a residual of one node's heading.
  void add_heading(std::size_t node, double residual, double weight) {
    add_block(node, node, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, weight);
    right_side_[3 * position(node) + 2] -= weight * residual;
  }
  void add(std::size_t first, std::size_t second, const PairResidual& residual, double weight) {
    add_block(first, first, residual.by_first, residual.by_first, weight);
    add_block(second, second, residual.by_second, residual.by_second, weight);
    if (position(first) > position(second)) {
      add_block(first, second, residual.by_first, residual.by_second, weight);
    } else {
      add_block(second, first, residual.by_second, residual.by_first, weight);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      right_side_[3 * position(first) + i] -= weight * residual.value * residual.by_first[i];
      right_side_[3 * position(second) + i] -= weight * residual.value * residual.by_second[i];
    }
  }
  /// What a residual that was added says of the scale, too.
  void add_scale(std::size_t first, std::size_t second, const PairResidual& residual,
                 double by_scale, double weight) {
    for (std::size_t i = 0; i < 3; ++i) {
      by_scale_[3 * position(first) + i] += weight * residual.by_first[i] * by_scale;
      by_scale_[3 * position(second) + i] += weight * residual.by_second[i] * by_scale;
    }
    add_scale(residual.value, by_scale, weight);
  }
  void add_scale(double residual, double by_scale, double weight) {
    scale_weight_ += weight * by_scale * by_scale;
    scale_right_ -= weight * residual * by_scale;
  }
  /// Holds a node where it is.
  void hold(std::size_t node, double weight) {
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<double, 3> unit{};
      unit[i] = 1.0;
      add_block(node, node, unit, unit, weight);
    }
  }

  /// Moves the poses. @return root mean square of the moves; negative when the system is singular
  double solve(Unknowns& unknowns) {
    if (matrix_.factorize() != -1) return -1.0;
    matrix_.solve(right_side_.data());
    unknowns.length_scale += eliminate_scale();
    std::vector<Pose2>& poses = unknowns.map_from_node;
    double squares = 0.0;
    for (std::size_t k = 0; k < nodes_; ++k) {
      const double* const step = right_side_.data() + 3 * position(k);
      poses[k] = {poses[k].x_m + step[0], poses[k].y_m + step[1],
                  wrap_angle(poses[k].theta_rad + step[2])};
      squares += step[0] * step[0] + step[1] * step[1] + step[2] * step[2];
    }
    return std::isfinite(squares) ? std::sqrt(squares / static_cast<double>(nodes_)) : -1.0;
  }

 private:
  /// The step of the scale by the Schur complement; takes its part out of the nodes' steps.
  double eliminate_scale() {
    std::vector<double> node_by_scale = by_scale_;
    matrix_.solve(node_by_scale.data());
    const auto dot = [](const std::vector<double>& a, const std::vector<double>& b) {
      return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
    };
    const double step = (scale_right_ - dot(by_scale_, right_side_)) /
                        (scale_weight_ - dot(by_scale_, node_by_scale));
    for (std::size_t i = 0; i < right_side_.size(); ++i) right_side_[i] -= step * node_by_scale[i];
    return step;
  }
  [[nodiscard]] std::size_t position(std::size_t node) const {
    return static_cast<std::size_t>(supernodes_.position[node]);
  }
  void add_block(std::size_t row, std::size_t column, const std::array<double, 3>& by_row,
                 const std::array<double, 3>& by_column, double weight) {
    const BlockPlace place = matrix_.place(supernodes_.position[row], supernodes_.position[column]);
    double* const block = matrix_.values() + place.offset;
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = 0; i < 3; ++i) {
        block[i + j * static_cast<std::size_t>(place.stride)] += weight * by_row[i] * by_column[j];
      }
    }
  }

  Supernodes supernodes_;
  BlockCholesky<3> matrix_;
  std::size_t nodes_;
  std::vector<double> right_side_;
  std::vector<double> by_scale_;  ///< of the normal matrix, the scale's column
  double scale_weight_ = 0.0;
  double scale_right_ = 0.0;
};

/// Geman and McClure's weight: 1 at 0, and 0 for what is far off.
double geman_mcclure(double squared, double scale_squared) {
  const double share = scale_squared / (scale_squared + squared);
  return share * share;
}

/// Odometry's step into a node against the poses.
std::array<PairResidual, 3> residuals_of_step(const SonarBatch& batch, const Unknowns& unknowns,
                                              std::size_t node) {
  const Pose2& driven = batch.steps[node].before_from_here;
  const Pose2 scaled{unknowns.length_scale * driven.x_m, unknowns.length_scale * driven.y_m,
                     driven.theta_rad};
  return step_residuals(unknowns.map_from_node[node - 1], unknowns.map_from_node[node], scaled);
}

std::array<double, 3> variances_of(const DrivenStep& step) {
  return {step.along_sigma_m * step.along_sigma_m, step.across_sigma_m * step.across_sigma_m,
          step.turn_sigma_rad * step.turn_sigma_rad};
}

void add_steps(const SonarBatch& batch, const SonarBatchOptions& options, const Unknowns& unknowns,
               Equations& equations) {
  const double robust = options.step_robust_sigmas * options.step_robust_sigmas;
  for (std::size_t k = 1; k < batch.steps.size(); ++k) {
    const Pose2& driven = batch.steps[k].before_from_here;
    const auto residuals = residuals_of_step(batch, unknowns, k);
    const std::array by_scale = {-driven.x_m, -driven.y_m, 0.0};
    const std::array variances = variances_of(batch.steps[k]);
    for (std::size_t i = 0; i < 3; ++i) {
      const double chi = residuals[i].value * residuals[i].value / variances[i];
      const double weight = 1.0 / (variances[i] * (1.0 + chi / robust));
      equations.add(k - 1, k, residuals[i], weight);
      equations.add_scale(k - 1, k, residuals[i], by_scale[i], weight);
    }
  }
  const double variance = options.length_sigma * options.length_sigma;
  equations.add_scale(unknowns.length_scale - 1.0, 1.0, 1.0 / variance);
}

/// Cauchy's loss of all steps.
double strain_of(const SonarBatch& batch, const SonarBatchOptions& options,
                 const Unknowns& unknowns) {
  const double robust = options.step_robust_sigmas * options.step_robust_sigmas;
  double strain = 0.0;
  for (std::size_t k = 1; k < batch.steps.size(); ++k) {
    const auto residuals = residuals_of_step(batch, unknowns, k);
    const std::array variances = variances_of(batch.steps[k]);
    for (std::size_t i = 0; i < 3; ++i) {
      const double chi = residuals[i].value * residuals[i].value / variances[i];
      strain += robust / 2.0 * std::log1p(chi / robust);
    }
  }
  return strain;
}

double heading_sigma(const SeenWall& wall, const SonarBatchOptions& options) {
  return std::hypot(options.wall_heading_rad, kEndsM / wall.length_m);
}

void add_headings(const SonarBatch& batch, const SonarBatchOptions& options,
                  const std::vector<Pose2>& poses, Equations& equations) {
  for (std::size_t i = 0; i < batch.walls.size(); ++i) {
    const SeenWall& wall = batch.walls[i];
    const double off =
        wrap_quarter(poses[wall.node].theta_rad + wall.normal_rad - batch.direction_rad[i]);
    const double sigma = heading_sigma(wall, options);
    equations.add_heading(wall.node, off,
                          heading_information(wall, options) *
                              geman_mcclure(off * off, kFarSigmas * kFarSigmas * sigma * sigma));
  }
}

void add_pairs(const SonarBatch& batch, const SonarBatchOptions& options, const Round& round,
               const std::vector<Pose2>& poses, Equations& equations) {
  const double scale_m = round.scale_m;
  const double coarse = std::max(1.0, (scale_m / kFineScaleM) * (scale_m / kFineScaleM));
  const double variance = options.wall_sigma_m * options.wall_sigma_m * coarse;
  for (const WallPair& pair : round.pairs) {
    const SeenWall& a = batch.walls[pair.first];
    const SeenWall& b = batch.walls[pair.second];
    if (a.node == b.node) continue;
    const PairResidual across = across_residual(poses[a.node], a, poses[b.node], b, pair.along_m);
    const double one_wall = geman_mcclure(across.value * across.value, scale_m * scale_m);
    const double share = round.wall_weight * 2.0 /
                         (round.partners[pair.first] + round.partners[pair.second]) * one_wall;
    equations.add(a.node, b.node, across,
                  share * std::min({1.0, a.length_m, b.length_m}) / variance);
    const double turn =
        wrap_angle(poses[a.node].theta_rad + a.normal_rad - poses[b.node].theta_rad - b.normal_rad);
    const double ends = std::hypot(kEndsM / a.length_m, kEndsM / b.length_m);
    const double sigma = std::hypot(options.wall_heading_rad, ends);
    const double parallel = options.parallel_weight * share / (sigma * sigma) *
                            geman_mcclure(turn * turn, kFarSigmas * kFarSigmas * sigma * sigma);
    equations.add(a.node, b.node, {turn, {0.0, 0.0, 1.0}, {0.0, 0.0, -1.0}}, parallel);
  }
}

/// @param shrunk how far the scale has gone from the start's to the end's, [0, 1]
Round round_at(double shrunk, const SonarBatch& batch, const SonarBatchOptions& options,
               const std::vector<Pose2>& poses) {
  Round round;
  round.scale_m =
      options.start_scale_m * std::pow(options.end_scale_m / options.start_scale_m, shrunk);
  round.wall_weight =
      options.start_wall_weight * std::pow(options.wall_weight / options.start_wall_weight, shrunk);
  round.pairs = find_wall_pairs(batch.walls, poses, round.scale_m, options.pairs);
  round.partners.assign(batch.walls.size(), 0);
  for (const WallPair& pair : round.pairs) {
    ++round.partners[pair.first];
    ++round.partners[pair.second];
  }
  return round;
}

/// A few Gauss-Newton steps with the pairs as they are. False when a system was singular.
bool settle(const SonarBatch& batch, const SonarBatchOptions& options, const Round& round,
            Unknowns& unknowns) {
  const std::size_t nodes = unknowns.map_from_node.size();
  std::vector<NodePair> coupled;
  for (std::size_t k = 1; k < nodes; ++k) {
    coupled.emplace_back(static_cast<std::int32_t>(k - 1), static_cast<std::int32_t>(k));
  }
  for (const WallPair& pair : round.pairs) {
    coupled.emplace_back(static_cast<std::int32_t>(batch.walls[pair.first].node),
                         static_cast<std::int32_t>(batch.walls[pair.second].node));
  }
  Equations equations(nodes, coupled);
  for (int step = 0; step < kStepsARound; ++step) {
    equations.clear();
    equations.hold(0, kFirmly);
    add_steps(batch, options, unknowns, equations);
    add_headings(batch, options, unknowns.map_from_node, equations);
    add_pairs(batch, options, round, unknowns.map_from_node, equations);
    Unknowns moved = unknowns;
    const double move = equations.solve(moved);
    if (move < 0.0) return false;
    unknowns = std::move(moved);
    if (move < kStillM) break;
  }
  return true;
}

}  // namespace

double heading_information(const SeenWall& wall, const SonarBatchOptions& options) {
  const double sigma = heading_sigma(wall, options);
  return options.heading_weight * std::min(1.0, wall.length_m) / (sigma * sigma);
}

SonarBatchResult solve_sonar_batch(const SonarBatch& batch, const SonarBatchOptions& options) {
  SonarBatchResult result;
  Unknowns unknowns{batch.map_from_node};
  result.solved = true;
  for (const double shrunk : kShrunk) {
    const Round round = round_at(shrunk, batch, options, unknowns.map_from_node);
    result.pairs = round.pairs.size();
    if (!settle(batch, options, round, unknowns)) {
      result.solved = false;
      break;
    }
  }
  result.strain = strain_of(batch, options, unknowns);
  result.map_from_node = std::move(unknowns.map_from_node);
  result.length_scale = unknowns.length_scale;
  return result;
}

}  // namespace roomatlas
