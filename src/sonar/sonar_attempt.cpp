// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_attempt.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "node_headings.hpp"

namespace roomatlas {
namespace {

constexpr double kContradictedCounts = 3.0;  // metres confirmed that one contradicted takes back:
                                             // less lets a slip win that brings walls together by
                                             // chance
// A score is better from so many metres of wall, or such a share, on: less is noise.
constexpr double kBetterShare = 0.02;
constexpr double kBetterM = 10.0;

SonarProblem problem_of(const SonarMission& mission, const Idea& idea,
                        const std::vector<Pose2>& start,
                        const std::vector<double>& directions_rad) {
  SonarProblem problem = sonar_problem(mission.readings, idea.problem.path, start, directions_rad,
                                       mission.options.segments, mission.jobs);
  for (DrivenStep& step : problem.batch.steps) step.turn_sigma_rad *= idea.doubt;
  return problem;
}

SonarBatchOptions options_of(const Idea& idea, SonarBatchOptions options) {
  if (!idea.follows_directions()) {
    options.heading_weight = 0.0;
    options.settled_heading_weight = 0.0;
  }
  return options;
}

/// One batch from the given poses, and its score.
Attempt solve_from(const SonarMission& mission, const Idea& idea, const std::vector<Pose2>& start,
                   const std::vector<double>& directions_rad, SonarBatchOptions batch_options) {
  Attempt attempt;
  const DrivenPath& path = idea.problem.path;
  SonarProblem problem = problem_of(mission, idea, start, directions_rad);
  batch_options = options_of(idea, batch_options);
  SonarBatchResult solved = solve_sonar_batch(problem.batch, batch_options);
  attempt.directions_rad = std::move(solved.directions_rad);
  attempt.length_scale = solved.length_scale;
  attempt.length_scale_sigma = solved.length_scale_sigma;
  attempt.clutter_m = solved.clutter_m;
  attempt.strain = solved.strain;
  attempt.map_from_robot = poses_of(path, problem, solved.map_from_node);
  const auto turned = with_headings_of_returns(mission.readings, problem, attempt.map_from_robot,
                                               solved.map_from_node, batch_options, mission.jobs);
  attempt.map_from_robot = poses_of(path, problem, turned);
  const Contradiction contradiction =
      contradiction_of(mission.readings, attempt.map_from_robot, path.path_m, problem.segments, {});
  attempt.score_m =
      solved.solved ? score_of(contradiction) : -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mission.readings.size(); ++i) {
    attempt.score_of_reading_m.push_back(contradiction.confirmed_of_reading_m[i] -
                                         kContradictedCounts *
                                             contradiction.contradicted_of_reading_m[i]);
  }
  attempt.is_odometry = idea.is_odometry;
  attempt.is_free = idea.is_free;
  attempt.variant.habits = idea.habits;
  attempt.variant.pairs = solved.pairs;
  if (solved.solved) {
    attempt.variant.compared_m = contradiction.compared_m();
    attempt.variant.contradiction = contradiction.share();
  }
  return attempt;
}

}  // namespace

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

void set_aside(Attempt attempt, std::vector<Attempt>& others) {
  if (!std::isfinite(attempt.score_m)) return;  // its equations had no solution
  others.push_back(std::move(attempt));
}

double score_of(const Contradiction& contradiction) {
  return contradiction.confirmed_m - kContradictedCounts * contradiction.contradicted_m;
}

bool is_better(const Attempt& attempt, const Attempt& than) {
  return attempt.score_m > than.score_m + std::max(kBetterM, kBetterShare * than.score_m);
}

double merit(const Attempt& attempt) { return attempt.score_m - attempt.strain; }

bool takes_over(const Idea& idea, const Idea& best) {
  constexpr double kOdometryTells = 5.0;    // of merit; less is noise
  constexpr double kStrainTells = 0.75;     // of the best's strain: false wings leave 0.89 and more
  constexpr double kFreeTells = 25.0;       // rectangular buildings gain up to 33 by it, ...
  constexpr double kFreeTellsShare = 0.05;  // ... those over 25 up to 2 %
  const double more = merit(idea.attempt) - merit(best.attempt);
  if (idea.is_odometry)
    return is_better(idea.attempt, best.attempt) && more > best.heading.log_evidence;
  if (idea.is_free && idea.followed_share < kByChance) return more > 0.0;
  if (idea.is_free) return more > std::max(kFreeTells, kFreeTellsShare * merit(best.attempt));
  if (idea.is_open && idea.directions_rad.size() > best.directions_rad.size()) {
    return more > kOdometryTells && idea.attempt.strain < kStrainTells * best.attempt.strain;
  }
  if (idea.is_open && more > 0.0) return true;
  return is_better(idea.attempt, best.attempt) && more > 0.0;
}

OdometryHabits learnt_habits(const SonarMission& mission, const Idea& idea) {
  OdometryHabits habits = idea.habits;
  habits.bias_rad_per_m = 0.0;
  habits.turn_gain = 1.0;
  const auto driven = driven_path(mission.readings, mission.directions, habits).odom_from_robot;
  const OdometryHabits learnt = habits_between(driven, idea.attempt.map_from_robot, false);
  habits.bias_rad_per_m = learnt.bias_rad_per_m;
  habits.turn_gain = learnt.turn_gain;
  return habits;
}

Attempt solve(const SonarMission& mission, const Idea& idea, std::string name,
              std::vector<double> correction_rad, SonarBatchOptions batch_options) {
  const auto start = with_headings(idea.problem.path, by_reading(idea.problem, correction_rad));
  Attempt attempt = solve_from(mission, idea, start, idea.directions_rad, batch_options);
  attempt.variant.name = std::move(name);
  attempt.correction_rad = std::move(correction_rad);
  return attempt;
}

Attempt solve_again(const SonarMission& mission, const Idea& idea, std::string name,
                    const SonarBatchOptions& batch_options) {
  Attempt attempt = solve_from(mission, idea, idea.attempt.map_from_robot,
                               idea.attempt.directions_rad, batch_options);
  attempt.variant.name = std::move(name);
  attempt.correction_rad = idea.attempt.correction_rad;
  return attempt;
}

Sharpened with_returns(const SonarMission& mission, const Idea& idea) {
  const std::vector<Pose2>& start = idea.attempt.map_from_robot;
  SonarProblem problem = problem_of(mission, idea, start, idea.attempt.directions_rad);
  problem.batch.returns = seen_returns(mission.readings, idea.problem.path, problem);
  SonarBatchOptions options = options_of(idea, {});
  options.is_settled = true;
  SonarBatchResult solved = solve_sonar_batch(problem.batch, options);
  if (!solved.solved) return {start, idea.attempt.length_scale, {}, {}};
  return {poses_of(idea.problem.path, problem, solved.map_from_node),
          solved.length_scale,
          {std::move(solved.moves), problem.node_of},
          {std::move(solved.wild), problem.node_of}};
}

Idea idea_of(const SonarMission& mission, const Calibration& calibration,
             const std::vector<double>& directions_rad) {
  Idea idea;
  idea.directions_rad = directions_rad;
  idea.habits = calibration.habits;
  idea.doubt = calibration.doubt;
  idea.chain_options = calibration.doubting({});
  idea.problem = heading_problem(mission.readings, mission.directions, idea.habits,
                                 mission.options.segments, mission.jobs);
  idea.heading = mission_heading(idea.problem.nodes, idea.problem.sightings, idea.directions_rad,
                                 idea.chain_options);
  return idea;
}

}  // namespace roomatlas
