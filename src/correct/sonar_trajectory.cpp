// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/correct/sonar_trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "heading_chain.hpp"
#include "roomatlas/match/contradiction.hpp"
#include "sonar_calibration.hpp"
#include "sonar_problem.hpp"

namespace roomatlas {
namespace {

const std::vector<double> kOneDirection = {0.0};

using Readings = std::span<const RangeReading>;

/// The chain's values by node as values by reading, those between nodes by way and turn.
std::vector<double> by_reading(const HeadingProblem& problem, const std::vector<double>& by_node) {
  std::vector<double> values;
  const auto& nodes = problem.node_readings;
  for (std::size_t i = 0, node = 0; i < problem.path.path_m.size(); ++i) {
    while (node + 1 < nodes.size() && nodes[node + 1] <= i) ++node;
    double value = by_node[node];
    if (node + 1 < nodes.size()) {
      const double share = share_between(problem.path, nodes[node], nodes[node + 1], i);
      value += share * (by_node[node + 1] - value);
    }
    values.push_back(value);
  }
  return values;
}

/// The posterior's mean given that the heading went the other way: smoothed about a heading that
/// has gone there already.
std::vector<double> slipped(const HeadingProblem& problem, const HeadingChainOptions& options,
                            const std::vector<double>& correction_rad, const HeadingSlip& slip) {
  std::vector<double> prior_rad = correction_rad;
  for (std::size_t k = slip.first_node; k < prior_rad.size(); ++k) {
    const std::size_t at = std::min(k - slip.first_node, slip.more_rad.size() - 1);
    prior_rad[k] += slip.more_rad[at];
  }
  std::vector<WallSighting> sightings = problem.sightings;
  for (WallSighting& wall : sightings) {
    wall.direction_rad = wrap_angle(wall.direction_rad + prior_rad[wall.node]);
  }
  const HeadingChain chain = smooth_heading(problem.nodes, sightings, kOneDirection, options);
  for (std::size_t k = 0; k < prior_rad.size(); ++k) {
    prior_rad[k] += chain.correction_rad[k];
  }
  return prior_rad;
}

/// A trajectory, and what its visits say of each other's walls.
struct Attempt {
  std::vector<double> correction_rad;  ///< of the heading, by node of the chain
  std::vector<Pose2> map_from_robot;
  SonarVariant variant;
  double score_m = 0.0;  ///< of wall: confirmed, less what is contradicted
};

/// By more than noise.
bool is_better(const Attempt& attempt, const Attempt& than) {
  constexpr double kShare = 0.02;
  constexpr double kLeastM = 10.0;
  return attempt.score_m > than.score_m + std::max(kLeastM, kShare * than.score_m);
}

/// Solves the mission with one heading. Wall that is contradicted counts three times.
Attempt solve(Readings readings, const DriveDirections& directions, const HeadingProblem& heading,
              std::string name, std::vector<double> correction_rad,
              const SonarTrajectoryOptions& options) {
  constexpr double kContradictedCounts = 3.0;
  Attempt attempt;
  const DrivenPath& path = heading.path;
  const auto start = with_headings(path, by_reading(heading, correction_rad));
  const SonarProblem problem = sonar_problem(readings, path, directions, start, options.segments);
  const SonarBatchResult solved = solve_sonar_batch(problem.batch, {});
  attempt.map_from_robot = poses_of(path, problem, solved.map_from_node);
  const Contradiction contradiction =
      contradiction_of(readings, attempt.map_from_robot, path.path_m, problem.segments, {});
  attempt.score_m = contradiction.confirmed_m - kContradictedCounts * contradiction.contradicted_m;
  attempt.variant.name = std::move(name);
  attempt.variant.pairs = solved.pairs;
  attempt.variant.compared_m = contradiction.compared_m();
  attempt.variant.contradiction = contradiction.share();
  attempt.correction_rad = std::move(correction_rad);
  return attempt;
}

/// Habits, the heading that they make likely, and what came of it.
struct Idea {
  OdometryHabits habits;
  HeadingChainOptions chain_options;
  HeadingProblem problem;
  HeadingChain chain;
  Attempt attempt;
};

Idea idea_of(Readings readings, const DriveDirections& directions, const OdometryHabits& habits,
             double drift, const SonarTrajectoryOptions& options) {
  Idea idea;
  idea.habits = habits;
  idea.chain_options.drift_rad_per_sqrt_m *= drift;
  idea.problem = heading_problem(readings, directions, habits, options.segments);
  idea.chain =
      smooth_heading(idea.problem.nodes, idea.problem.sightings, kOneDirection, idea.chain_options);
  return idea;
}

/// Slips of the heading that a freer odometry would allow, the likeliest first.
std::vector<HeadingSlip> possible_slips(const Idea& idea) {
  constexpr double kLeastShare = 0.01;
  constexpr std::size_t kMost = 12;
  constexpr double kFreer = 2.5;
  HeadingChainOptions loose = idea.chain_options;
  loose.trust /= 2.0;
  loose.drift_rad_per_sqrt_m *= kFreer;
  loose.drift_per_turn *= kFreer;
  std::vector<HeadingSlip> slips;
  for (HeadingSlip& slip : find_slips(idea.problem.nodes, idea.problem.sightings, kOneDirection,
                                      loose, idea.chain.correction_rad)) {
    if (slip.share >= kLeastShare && slips.size() < kMost) slips.push_back(std::move(slip));
  }
  return slips;
}

/// Tries the other ways that the heading may have gone, and keeps what brings more walls together.
void repair_slips(Readings readings, const DriveDirections& directions,
                  const SonarTrajectoryOptions& options, Idea& idea, SonarTrajectory& result) {
  constexpr int kMostTries = 12;
  std::vector<HeadingSlip> slips = possible_slips(idea);
  for (int tries = 0; !slips.empty() && tries < kMostTries;) {
    std::optional<Attempt> better;
    std::size_t better_slip = 0;
    for (std::size_t i = 0; i < slips.size() && tries < kMostTries; ++i, ++tries) {
      const double quarter = degrees(slips[i].more_rad.back());
      const auto at_m = std::lround(idea.problem.nodes[slips[i].first_node].path_m);
      std::string name = "turned by " + std::to_string(std::lround(quarter)) + " deg from " +
                         std::to_string(at_m) + " m on";
      Attempt attempt =
          solve(readings, directions, idea.problem, std::move(name),
                slipped(idea.problem, idea.chain_options, idea.attempt.correction_rad, slips[i]),
                options);
      attempt.variant.habits = idea.habits;
      result.variants.push_back(attempt.variant);
      if (!is_better(attempt, idea.attempt)) continue;
      if (better && attempt.score_m <= better->score_m) continue;
      better = std::move(attempt);
      better_slip = i;
      result.chosen = result.variants.size() - 1;
    }
    if (!better) break;
    idea.attempt = std::move(*better);
    slips.erase(slips.begin() + static_cast<std::ptrdiff_t>(better_slip));
    ++result.slips_repaired;
  }
}

/// A change of the likeliest habits, or of how far odometry is believed: where the heading's
/// winding hangs in the balance, one of these finds it.
struct Change {
  const char* name;
  double bias_deg_per_m;
  double turn_gain;
  double drift;
};
constexpr Change kChanges[] = {
    {"as likely", 0.0, 0.0, 1.0},
    {"bias +0.25 deg/m, gain -0.01", 0.25, -0.01, 1.0},
    {"bias -0.25 deg/m, gain +0.01", -0.25, 0.01, 1.0},
    {"gain -0.02", 0.0, -0.02, 1.0},
    {"gain +0.02", 0.0, 0.02, 1.0},
    {"drift 0.6 of the usual", 0.0, 0.0, 0.6},
    {"drift 1.7 of the usual", 0.0, 0.0, 1.7},
};

OdometryHabits changed(OdometryHabits habits, const Change& change) {
  habits.bias_rad_per_m += radians(change.bias_deg_per_m);
  habits.turn_gain += change.turn_gain;
  return habits;
}

/// Whether enough wall was seen by several visits and they agree about it.
bool is_verified(const Attempt& attempt, const SonarTrajectoryOptions& options) {
  const SonarVariant& variant = attempt.variant;
  return variant.compared_m >= options.verified_m &&
         variant.contradiction <= options.verified_share;
}

/// Moves a trajectory so that it begins where odometry does.
void begin_at(const Pose2& first, std::vector<Pose2>& poses) {
  const Pose2 moved = first * inverse(poses.front());
  for (Pose2& pose : poses) pose = moved * pose;
}

}  // namespace

SonarTrajectory correct_sonar_trajectory(Readings readings, const SonarTrajectoryOptions& options) {
  SonarTrajectory result;
  if (readings.empty()) return result;
  const DriveDirections directions = find_drive_directions(readings, options.directions);
  result.intervals_reversed = directions.intervals_reversed;
  result.undecided_m = directions.undecided_m.back();
  OdometryHabits likely;
  if (options.calibrate) likely = calibrate_odometry(readings, directions, options.segments, {});
  std::optional<Idea> best;
  const std::size_t ideas = options.calibrate ? std::size(kChanges) : 1;
  for (const Change& change : std::span(kChanges).first(ideas)) {
    Idea idea = idea_of(readings, directions, changed(likely, change), change.drift, options);
    Attempt attempt =
        solve(readings, directions, idea.problem, change.name, idea.chain.correction_rad, options);
    attempt.variant.habits = idea.habits;
    result.variants.push_back(attempt.variant);
    if (best && !is_better(attempt, best->attempt)) continue;
    result.chosen = result.variants.size() - 1;
    idea.attempt = std::move(attempt);
    best = std::move(idea);
  }
  {  // where walls have no common direction, odometry's own headings are better than any found
    Idea plain = idea_of(readings, directions, {}, 1.0, options);
    plain.chain.correction_rad.assign(plain.chain.correction_rad.size(), 0.0);
    plain.attempt = solve(readings, directions, plain.problem, "odometry's headings",
                          plain.chain.correction_rad, options);
    result.variants.push_back(plain.attempt.variant);
    if (is_better(plain.attempt, best->attempt)) {
      result.chosen = result.variants.size() - 1;
      best = std::move(plain);
    }
  }
  if (options.repair_slips) repair_slips(readings, directions, options, *best, result);
  result.habits = best->habits;
  result.log_evidence = best->chain.log_evidence;
  result.heading_sigma_rad = by_reading(best->problem, best->chain.sigma_rad);
  result.segments = best->problem.segments.size();
  result.loops_verified = is_verified(best->attempt, options);
  result.map_from_robot = std::move(best->attempt.map_from_robot);
  begin_at(readings.front().odom_from_robot, result.map_from_robot);
  return result;
}

}  // namespace roomatlas
