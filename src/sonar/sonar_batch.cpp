// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_batch.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "pose_spread.hpp"
#include "sonar_equations.hpp"
#include "wall_headings.hpp"

namespace roomatlas {
namespace {

/// How far each round's scale has gone from the start's to the end's, on a logarithmic scale.
constexpr std::array kShrunk = {0.0, 0.0,  0.0,  0.1, 0.1, 0.22, 0.22, 0.3, 0.3, 0.4,
                                0.4, 0.52, 0.52, 0.7, 0.7, 0.82, 0.92, 1.0, 1.0};
constexpr std::size_t kWithReturns = 4;  // rounds at the end in which single returns count
constexpr int kStepsARound = 3;          // more settle on pairs that the next round drops
constexpr double kFineScaleM = 0.15;     // below it walls count in full
constexpr double kFirmly = 1e6;   // weight that holds the first node: more than all walls together
constexpr double kStillM = 1e-4;  // root mean square of the moves at which a round ends

/// Which walls are one, and how much that counts.
struct Round {
  double scale_m = 0.0;       ///< across, at which Geman and McClure let go of a pair
  double wall_weight = 0.0;   ///< of a wall's partners together
  double length_sigma = 0.0;  ///< of odometry's lengths as a whole, as a share
  std::vector<WallPair> pairs;
  std::vector<int> partners;  ///< of each wall
  std::vector<ReturnMatch> returns;
  double clutter_m = 0.0;  ///< of the last rounds, as the poses stand when they begin
  bool is_last = false;
};

/// What is solved for.
struct Unknowns {
  std::vector<Pose2> map_from_node;
  std::vector<std::vector<Pose2>> moves;  ///< drawn of the last round
  std::vector<std::vector<Pose2>> wild;   ///< the same, by the wild bootstrap
  SharedUnknowns shared;
  double length_scale_sigma = 0.0;
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
  const double scale = unknowns.shared.length_scale;
  const Pose2 scaled{scale * driven.x_m, scale * driven.y_m, driven.theta_rad};
  return step_residuals(unknowns.map_from_node[node - 1], unknowns.map_from_node[node], scaled);
}

std::array<double, 3> variances_of(const DrivenStep& step) {
  return {step.along_sigma_m * step.along_sigma_m, step.across_sigma_m * step.across_sigma_m,
          step.turn_sigma_rad * step.turn_sigma_rad};
}

void add_steps(const SonarBatch& batch, const SonarBatchOptions& options, double length_sigma,
               const Unknowns& unknowns, const std::vector<PairPlaces>& into_node,
               SonarEquations& equations) {
  const double robust = options.step_robust_sigmas * options.step_robust_sigmas;
  for (std::size_t k = 1; k < batch.steps.size(); ++k) {
    const Pose2& driven = batch.steps[k].before_from_here;
    equations.begin(ResidualKind::step, k, k);
    const auto residuals = residuals_of_step(batch, unknowns, k);
    const std::array by_scale = {-driven.x_m, -driven.y_m, 0.0};
    const std::array variances = variances_of(batch.steps[k]);
    for (std::size_t i = 0; i < 3; ++i) {
      const double chi = residuals[i].value * residuals[i].value / variances[i];
      const double weight = 1.0 / (variances[i] * (1.0 + chi / robust));
      equations.add(into_node[k - 1], residuals[i], weight);
      equations.add_scale(into_node[k - 1], residuals[i], by_scale[i], weight);
    }
  }
  equations.begin(ResidualKind::prior, 0, 0);
  equations.add_scale(unknowns.shared.length_scale - 1.0, 1.0, 1.0 / (length_sigma * length_sigma));
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

/// What the residuals of a wall's direction ask of it, however the poses stand.
struct WallHeading {
  double information = 0.0;
  double far_squared = 0.0;
};

std::vector<WallHeading> headings_of(const SonarBatch& batch, const SonarBatchOptions& options) {
  std::vector<WallHeading> headings;
  for (const SeenWall& wall : batch.walls) {
    headings.push_back(
        {heading_information(wall, options), far_squared(sought_variance(wall, options))});
  }
  return headings;
}

void add_headings(const SonarBatch& batch, const SonarBatchOptions& options,
                  const std::vector<WallHeading>& headings, const Unknowns& unknowns,
                  SonarEquations& equations) {
  const std::vector<double>& directions_rad = unknowns.shared.directions_rad;
  const double found_information =
      1.0 / (options.direction_sigma_rad * options.direction_sigma_rad);
  equations.begin(ResidualKind::prior, 0, 0);
  for (std::size_t i = 1; i < directions_rad.size(); ++i) {
    equations.add_direction(i, directions_rad[i] - batch.directions_rad[i], found_information);
  }
  for (std::size_t i = 0; i < batch.walls.size(); ++i) {
    const SeenWall& wall = batch.walls[i];
    const double off = wrap_quarter(unknowns.map_from_node[wall.node].theta_rad + wall.normal_rad -
                                    directions_rad[wall.direction]);
    equations.begin(ResidualKind::heading, wall.node, wall.node);
    equations.add_heading(
        wall.node, wall.direction, off,
        headings[i].information * geman_mcclure(off * off, headings[i].far_squared));
  }
}

/// What the residuals of a pair ask of it, however the poses stand.
struct JoinedPair {
  PairPlaces places;
  std::size_t first = 0;  ///< walls
  std::size_t second = 0;
  Point2 point_node;  ///< of the second wall, in the middle of the overlap
  double even = 0.0;  ///< weight by the number of both walls' partners
  double length_m = 0.0;
  double heading_variance = 0.0;
  double far_squared = 0.0;
};

std::vector<JoinedPair> joined(const SonarBatch& batch, const SonarBatchOptions& options,
                               const Round& round, const SonarEquations& equations) {
  std::vector<JoinedPair> pairs;
  pairs.reserve(round.pairs.size());
  for (const WallPair& pair : round.pairs) {
    const SeenWall& a = batch.walls[pair.first];
    const SeenWall& b = batch.walls[pair.second];
    if (a.node == b.node) continue;
    const double variance = sought_variance(a, b, options);
    pairs.push_back(
        {equations.places_of(a.node, b.node), pair.first, pair.second, point_on(b, pair.along_m),
         round.wall_weight * 2.0 / (round.partners[pair.first] + round.partners[pair.second]),
         std::min({1.0, a.length_m, b.length_m}), variance, far_squared(variance)});
  }
  return pairs;
}

void add_pairs(const SonarBatch& batch, const SonarBatchOptions& options, const Round& round,
               const std::vector<JoinedPair>& pairs, const std::vector<Pose2>& poses,
               SonarEquations& equations) {
  const double scale_m = round.scale_m;
  const double coarse = std::max(1.0, (scale_m / kFineScaleM) * (scale_m / kFineScaleM));
  const double variance = options.wall_sigma_m * options.wall_sigma_m * coarse;
  std::vector<PointTransform> places;
  places.reserve(poses.size());
  for (const Pose2& pose : poses) places.emplace_back(pose);
  std::vector<PlacedWall> walls;
  walls.reserve(batch.walls.size());
  for (const SeenWall& wall : batch.walls) {
    walls.push_back(placed(wall, poses[wall.node], places[wall.node]));
  }
  for (const JoinedPair& pair : pairs) {
    const PlacedWall& a = walls[pair.first];
    const SeenWall& b = batch.walls[pair.second];
    const Pose2& map_from_second = poses[b.node];
    const PairResidual across =
        across_residual(a, map_from_second.position(), places[b.node] * pair.point_node);
    const double one_wall = geman_mcclure(across.value * across.value, scale_m * scale_m);
    const double share = pair.even * one_wall;
    equations.begin(ResidualKind::pair, batch.walls[pair.first].node, b.node);
    equations.add(pair.places, across, share * pair.length_m / variance);
    const double turn = wrap_angle(a.normal_rad - map_from_second.theta_rad - b.normal_rad);
    const double parallel = options.parallel_weight * share / pair.heading_variance *
                            geman_mcclure(turn * turn, pair.far_squared);
    equations.add_turn(pair.places, turn, parallel);
  }
}

void add_returns(const SonarBatch& batch, const SonarBatchOptions& options, const Round& round,
                 const std::vector<Pose2>& poses, SonarEquations& equations) {
  constexpr double kRobust = 4.0;  // squared sigmas: returns off by more lose weight
  const double variance = options.return_sigma_m * options.return_sigma_m;
  for (const ReturnMatch& match : round.returns) {
    const SeenReturn& seen = batch.returns[match.heard];
    const SeenWall& wall = batch.walls[match.wall];
    const auto residual = range_residual(poses[seen.node], seen, poses[wall.node], wall);
    if (!residual) continue;
    const double chi = residual->value * residual->value / variance;
    const double share = options.return_share * seen.share * match.share;
    equations.begin(ResidualKind::range, seen.node, wall.node);
    equations.add(equations.places_of(seen.node, wall.node), *residual,
                  share / (variance * (1.0 + chi / kRobust)));
  }
}

/// Of odometry's lengths as a whole, once it is known which walls are one.
double length_sigma_in(double clutter_m, const SonarBatchOptions& options) {
  const double share = options.clutter_m / std::max(options.clutter_m, clutter_m);
  return options.length_sigma * share * share;
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
  round.length_sigma = options.start_length_sigma;
  if (shrunk == 1.0) {
    round.clutter_m = clutter_of(batch.walls, round.pairs, poses);
    round.length_sigma = length_sigma_in(round.clutter_m, options);
  }
  return round;
}

/// A few Gauss-Newton steps with the pairs as they are. False when a system was singular.
bool settle(const SonarBatch& batch, const SonarBatchOptions& options,
            const std::vector<WallHeading>& headings, const Round& round, Unknowns& unknowns) {
  const std::size_t nodes = unknowns.map_from_node.size();
  std::vector<NodePair> coupled;
  for (std::size_t k = 1; k < nodes; ++k) {
    coupled.emplace_back(static_cast<std::int32_t>(k - 1), static_cast<std::int32_t>(k));
  }
  for (const WallPair& pair : round.pairs) {
    coupled.emplace_back(static_cast<std::int32_t>(batch.walls[pair.first].node),
                         static_cast<std::int32_t>(batch.walls[pair.second].node));
  }
  for (const ReturnMatch& match : round.returns) {
    coupled.emplace_back(static_cast<std::int32_t>(batch.returns[match.heard].node),
                         static_cast<std::int32_t>(batch.walls[match.wall].node));
  }
  const bool is_drawn = round.is_last && options.is_settled;
  SonarEquations equations(nodes, coupled, batch.directions_rad.size(), is_drawn ? kDraws : 0);
  std::vector<PairPlaces> into_node;
  for (std::size_t k = 1; k < nodes; ++k) into_node.push_back(equations.places_of(k - 1, k));
  const std::vector<JoinedPair> pairs = joined(batch, options, round, equations);
  for (int step = 0; step < kStepsARound; ++step) {
    equations.clear();
    equations.hold(0, kFirmly);
    add_steps(batch, options, round.length_sigma, unknowns, into_node, equations);
    add_headings(batch, options, headings, unknowns, equations);
    add_pairs(batch, options, round, pairs, unknowns.map_from_node, equations);
    add_returns(batch, options, round, unknowns.map_from_node, equations);
    Unknowns moved = unknowns;
    const double move = equations.solve(moved.map_from_node, moved.shared);
    moved.length_scale_sigma = equations.scale_sigma();
    if (move < 0.0) return false;
    unknowns = std::move(moved);
    if (move < kStillM) break;
  }
  if (is_drawn) {
    unknowns.moves = drawn_moves(equations, unknowns.map_from_node);
    unknowns.wild = wild_moves(equations, unknowns.map_from_node);
  }
  return true;
}

}  // namespace

double clutter_of(const std::vector<SeenWall>& walls, const std::vector<WallPair>& pairs,
                  const std::vector<Pose2>& map_from_node) {
  double apart = 0.0;
  double scatter = 0.0;
  std::size_t count = 0;
  for (const WallPair& pair : pairs) {
    const SeenWall& a = walls[pair.first];
    const SeenWall& b = walls[pair.second];
    if (a.node == b.node) continue;
    const double across_m =
        across_residual(map_from_node[a.node], a, map_from_node[b.node], b, pair.along_m).value;
    apart += across_m * across_m;
    scatter += (a.sigma_m * a.sigma_m + b.sigma_m * b.sigma_m) / 2.0;
    ++count;
  }
  return count == 0 ? 0.0 : std::sqrt(std::max(0.0, apart - scatter) / static_cast<double>(count));
}

SonarBatchResult solve_sonar_batch(const SonarBatch& batch, const SonarBatchOptions& options) {
  SonarBatchResult result;
  Unknowns unknowns;
  unknowns.map_from_node = batch.map_from_node;
  unknowns.shared.directions_rad = batch.directions_rad;
  result.solved = true;
  const std::vector<WallHeading> headings = headings_of(batch, options);
  const std::size_t past = kShrunk.size() + (batch.returns.empty() ? 0 : kWithReturns);
  for (std::size_t i = options.is_settled ? kShrunk.size() - 1 : 0; i < past; ++i) {
    const bool are_pairs_known = i >= kShrunk.size();
    Round round =
        round_at(are_pairs_known ? 1.0 : kShrunk[i], batch, options, unknowns.map_from_node);
    if (are_pairs_known) {
      round.returns = find_return_matches(batch.returns, batch.walls, unknowns.map_from_node);
    }
    round.is_last = i + 1 == past;
    result.pairs = round.pairs.size();
    result.clutter_m = round.clutter_m;
    if (!settle(batch, options, headings, round, unknowns)) {
      result.solved = false;
      break;
    }
  }
  result.strain = strain_of(batch, options, unknowns);
  result.map_from_node = std::move(unknowns.map_from_node);
  result.moves = std::move(unknowns.moves);
  result.wild = std::move(unknowns.wild);
  result.directions_rad = std::move(unknowns.shared.directions_rad);
  result.length_scale = unknowns.shared.length_scale;
  result.length_scale_sigma = unknowns.length_scale_sigma;
  return result;
}

}  // namespace roomatlas
