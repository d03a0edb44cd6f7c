// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_rivals.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "pose_spread.hpp"
#include "roomatlas/core/paired_difference.hpp"
#include "roomatlas/sonar/contradiction.hpp"

namespace roomatlas {
namespace {

constexpr double kLeastTurned = 0.05;  // of the readings; what turns less is a corner of the plan

/// Share of the readings whose headings part for good: by more than odds and ends of a turn.
double share_turned(const std::vector<Pose2>& a, const std::vector<Pose2>& b) {
  constexpr double kTurned = radians(30.0);  // a third of a slip
  const auto apart = [&](std::size_t i) { return wrap_angle(a[i].theta_rad - b[i].theta_rad); };
  const double middle = apart(a.size() / 2);
  std::size_t turned = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::abs(wrap_angle(apart(i) - middle)) > kTurned) ++turned;
  }
  return static_cast<double>(turned) / static_cast<double>(a.size());
}

/// The score of an attempt by stretches of the mission that do not share their errors.
std::vector<double> score_of_stretches(std::span<const RangeReading> readings,
                                       const Attempt& attempt) {
  const double stretch_m = ContradictionOptions{}.same_visit_m;
  std::vector<double> scores{0.0};
  double path_m = 0.0;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (i > 0) {
      path_m +=
          (readings[i].odom_from_robot.position() - readings[i - 1].odom_from_robot.position())
              .norm();
    }
    if (path_m > stretch_m * static_cast<double>(scores.size())) scores.push_back(0.0);
    scores.back() += attempt.score_of_reading_m[i];
  }
  return scores;
}

/// Null where there is none.
const Attempt* best_in_directions(const std::vector<Attempt>& attempts) {
  const Attempt* best = nullptr;
  for (const Attempt& one : attempts) {
    if (one.follows_directions() && (best == nullptr || merit(one) > merit(*best))) best = &one;
  }
  return best;
}

}  // namespace

double share_with_sure_heading(const Idea& idea) {
  constexpr double kSure = radians(5.0);  // sigmas are 1.5 to 2.5 degrees where walls are heard,
                                          // and 4 to 9 where the heading may slip
  if (idea.is_odometry) return 1.0;
  const std::vector<double> sigmas_rad = by_reading(idea.problem, idea.heading.sigma_rad);
  const auto sure = std::count_if(sigmas_rad.begin(), sigmas_rad.end(),
                                  [](double sigma_rad) { return sigma_rad <= kSure; });
  return static_cast<double>(sure) / static_cast<double>(sigmas_rad.size());
}

double rival_score(const Attempt& kept, const std::vector<Attempt>& others) {
  double best = 0.0;
  for (const Attempt& other : others) {
    if (share_turned(other.map_from_robot, kept.map_from_robot) <= kLeastTurned) continue;
    best = std::max(best, other.score_m / std::max(1.0, kept.score_m));
  }
  return best;
}

double attempts_apart(const Attempt& kept, const std::vector<Attempt>& others) {
  constexpr double kFallsBehind = 0.05;  // of the score: weighs 1/e
  const double scale_m = kFallsBehind * std::max(1.0, kept.score_m);
  double weights = 1.0;
  double squares = 0.0;
  for (const Attempt& other : others) {
    const double behind_m = std::max(0.0, kept.score_m - other.score_m);
    const double weight = std::exp(-behind_m / scale_m);
    const double apart = apart_m(other.map_from_robot, kept.map_from_robot);
    weights += weight;
    squares += weight * apart * apart;
  }
  return std::sqrt(squares / weights);
}

DrawnMoves moves_of_readings(std::vector<Pose2> other, const std::vector<Pose2>& kept) {
  DrawnMoves moves{{moves_to(std::move(other), kept)}, {}};
  moves.node_of.resize(kept.size());
  std::iota(moves.node_of.begin(), moves.node_of.end(), std::size_t{0});
  return moves;
}

double headings_apart(const Attempt& kept, const std::vector<Attempt>& others) {
  constexpr double kFitsWorse = 25.0;  // of merit: weighs 1/e
  double weights = 1.0;
  double squares = 0.0;
  for (const Attempt& other : others) {
    if (!other.follows_directions()) continue;
    const double weight = std::exp(-std::max(0.0, merit(kept) - merit(other)) / kFitsWorse);
    const std::vector<Pose2> moves = moves_to(other.map_from_robot, kept.map_from_robot);
    const double sum = std::accumulate(
        moves.begin(), moves.end(), 0.0,
        [](double so_far, const Pose2& move) { return so_far + move.theta_rad * move.theta_rad; });
    weights += weight;
    squares += weight * sum / static_cast<double>(moves.size());
  }
  return std::sqrt(squares / weights);
}

CrossCheck cross_checked(const Attempt& kept, const Attempt& grown,
                         const std::vector<Attempt>& others) {
  const Attempt* other = kept.is_free ? best_in_directions(others) : &grown;
  if (other == nullptr || !std::isfinite(merit(*other))) return {};
  return {moves_of_readings(other->map_from_robot, kept.map_from_robot),
          (merit(kept) - merit(*other)) / std::max(1.0, kept.score_m)};
}

bool is_verified(const Idea& idea, const std::vector<Attempt>& others,
                 const SonarTrajectoryOptions& options) {
  const Attempt& kept = idea.attempt;
  constexpr double kCost = 0.2;  // of the score, for each share of the readings turned: less
                                 // proves nothing against the other winding
  const SonarVariant& variant = kept.variant;
  if (variant.compared_m < options.verified_m || variant.contradiction > options.verified_share ||
      share_with_sure_heading(idea) < options.verified_heading_share) {
    return false;
  }
  return std::none_of(others.begin(), others.end(), [&](const Attempt& other) {
    const double share = share_turned(other.map_from_robot, kept.map_from_robot);
    return share > kLeastTurned && other.score_m > (1.0 - kCost * share) * kept.score_m;
  });
}

const Attempt* second_answer(std::span<const RangeReading> readings, const Attempt& kept,
                             const std::vector<Attempt>& others) {
  const Attempt* best = nullptr;
  for (const Attempt& other : others) {
    if (share_turned(other.map_from_robot, kept.map_from_robot) <= kLeastTurned) continue;
    if (other.score_m > 0.0 && (best == nullptr || other.score_m > best->score_m)) best = &other;
  }
  if (best == nullptr) return nullptr;
  const PairedDifference difference =
      paired_difference(score_of_stretches(readings, kept), score_of_stretches(readings, *best));
  return difference.is_within_chance() ? best : nullptr;
}

}  // namespace roomatlas
