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
std::vector<double> slipped(const HeadingProblem& problem,
                            const std::vector<double>& directions_rad,
                            const HeadingChainOptions& options,
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
  const HeadingChain chain = smooth_heading(problem.nodes, sightings, directions_rad, options);
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

/// Solves the mission with one heading. Doubt widens what odometry may err in turns. Wall that is
/// contradicted counts three times.
Attempt solve(Readings readings, const DriveDirections& directions, const HeadingProblem& heading,
              const std::vector<double>& directions_rad, std::string name,
              std::vector<double> correction_rad, double doubt,
              const SonarTrajectoryOptions& options, const SonarBatchOptions& batch_options = {}) {
  constexpr double kContradictedCounts = 3.0;
  Attempt attempt;
  const DrivenPath& path = heading.path;
  const auto start = with_headings(path, by_reading(heading, correction_rad));
  SonarProblem problem =
      sonar_problem(readings, path, directions, start, directions_rad, options.segments);
  for (DrivenStep& step : problem.batch.steps) step.turn_sigma_rad *= doubt;
  const SonarBatchResult solved = solve_sonar_batch(problem.batch, batch_options);
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
  double doubt = 1.0;
  HeadingChainOptions chain_options;
  std::vector<double> directions_rad;  ///< of the building's walls
  HeadingProblem problem;
  HeadingChain chain;
  Attempt attempt;
};

/// @param drift times the calibration's
Idea idea_of(Readings readings, const DriveDirections& directions, const Calibration& calibration,
             double drift, const std::vector<double>& directions_rad,
             const SonarTrajectoryOptions& options) {
  Idea idea;
  idea.directions_rad = directions_rad;
  idea.habits = calibration.habits;
  idea.doubt = calibration.doubt;
  idea.chain_options = calibration.doubting({});
  idea.chain_options.drift_rad_per_sqrt_m *= drift;
  idea.problem = heading_problem(readings, directions, idea.habits, options.segments);
  idea.chain = smooth_heading(idea.problem.nodes, idea.problem.sightings, idea.directions_rad,
                              idea.chain_options);
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
  for (HeadingSlip& slip : find_slips(idea.problem.nodes, idea.problem.sightings,
                                      idea.directions_rad, loose, idea.chain.correction_rad)) {
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
          solve(readings, directions, idea.problem, idea.directions_rad, std::move(name),
                slipped(idea.problem, idea.directions_rad, idea.chain_options,
                        idea.attempt.correction_rad, slips[i]),
                idea.doubt, options);
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
    {"bias +0.25 deg/m, gain -0.03", 0.25, -0.03, 1.0},
    {"bias -0.25 deg/m, gain +0.03", -0.25, 0.03, 1.0},
    {"gain -0.03", 0.0, -0.03, 1.0},
    {"gain +0.03", 0.0, 0.03, 1.0},
    {"drift 1.7 of the usual", 0.0, 0.0, 1.7},
};

/// Where none of these is convincing.
constexpr Change kFurtherChanges[] = {
    {"bias +1 deg/m", 1.0, 0.0, 1.0},        {"bias -1 deg/m", -1.0, 0.0, 1.0},
    {"gain -0.06", 0.0, -0.06, 1.0},         {"gain +0.06", 0.0, 0.06, 1.0},
    {"drift half the usual", 0.0, 0.0, 0.5},
};

/// Whether the walls make one heading clearly more likely than walls that lie anyhow would: in a
/// round hall they do not.
bool walls_follow_directions(const HeadingProblem& problem,
                             const std::vector<double>& directions_rad,
                             const HeadingChainOptions& chain) {
  constexpr double kLeastASegment = 0.05;  // of log evidence
  const double evidence = heading_evidence(problem.nodes, problem.sightings, directions_rad, chain);
  return !problem.sightings.empty() &&
         evidence > kLeastASegment * static_cast<double>(problem.sightings.size());
}

Calibration changed(Calibration calibration, const Change& change) {
  calibration.habits.bias_rad_per_m += radians(change.bias_deg_per_m);
  calibration.habits.turn_gain += change.turn_gain;
  return calibration;
}

/// Whether two headings part for good: by more than odds and ends of a turn, for long.
bool winds_otherwise(const std::vector<Pose2>& a, const std::vector<Pose2>& b) {
  constexpr double kTurned = radians(30.0);
  constexpr double kShare = 0.05;  // of the readings
  const auto apart = [&](std::size_t i) { return wrap_angle(a[i].theta_rad - b[i].theta_rad); };
  std::size_t turned = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::abs(wrap_angle(apart(i) - apart(a.size() / 2))) > kTurned) ++turned;
  }
  return static_cast<double>(turned) > kShare * static_cast<double>(a.size());
}

/// Whether enough wall was seen by several visits, they agree about it, and no attempt that winds
/// otherwise does nearly as well.
bool is_verified(const Attempt& kept, const std::vector<Attempt>& others,
                 const SonarTrajectoryOptions& options) {
  constexpr double kNearly = 0.8;
  const SonarVariant& variant = kept.variant;
  if (variant.compared_m < options.verified_m || variant.contradiction > options.verified_share) {
    return false;
  }
  return std::none_of(others.begin(), others.end(), [&](const Attempt& other) {
    return other.score_m > kNearly * kept.score_m &&
           winds_otherwise(other.map_from_robot, kept.map_from_robot);
  });
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
  Calibration likely;
  if (options.calibrate) likely = calibrate_odometry(readings, directions, options.segments, {});
  const HeadingProblem likely_problem =
      heading_problem(readings, directions, likely.habits, options.segments);
  const HeadingChainOptions chain = likely.doubting({});
  const std::vector<double> directions_rad = building_directions(likely_problem, chain);
  std::optional<Idea> best;
  std::vector<Attempt> attempts;
  const auto offer = [&](Idea idea, Attempt attempt) {
    attempt.variant.habits = idea.habits;
    result.variants.push_back(attempt.variant);
    attempts.push_back(attempt);
    if (best && !is_better(attempt, best->attempt)) return;
    result.chosen = result.variants.size() - 1;
    idea.attempt = std::move(attempt);
    best = std::move(idea);
  };
  const auto consider = [&](const Change& change, const std::vector<double>& walls_rad) {
    Idea idea =
        idea_of(readings, directions, changed(likely, change), change.drift, walls_rad, options);
    std::string name = change.name;
    if (walls_rad.size() > 1) {
      name += ", walls in " + std::to_string(walls_rad.size()) + " directions";
    }
    Attempt attempt = solve(readings, directions, idea.problem, walls_rad, std::move(name),
                            idea.chain.correction_rad, idea.doubt, options);
    offer(std::move(idea), std::move(attempt));
  };
  const auto consider_odometry = [&] {
    Idea idea = idea_of(readings, directions, {}, 1.0, {0.0}, options);
    std::fill(idea.chain.correction_rad.begin(), idea.chain.correction_rad.end(), 0.0);
    SonarBatchOptions batch;
    batch.heading_weight = 0.0;
    Attempt attempt = solve(readings, directions, idea.problem, {0.0}, "odometry's own heading",
                            idea.chain.correction_rad, idea.doubt, options, batch);
    offer(std::move(idea), std::move(attempt));
  };
  const auto consider_all = [&](std::span<const Change> changes) {
    const std::vector<double> walls_rad = best->directions_rad;
    for (const Change& change : changes) consider(change, walls_rad);
  };
  // the first stays unless another is clearly better: wings at an angle are believed
  const bool follow = walls_follow_directions(likely_problem, directions_rad, chain);
  if (follow && directions_rad.size() > 1) consider(kChanges[0], directions_rad);
  if (follow) consider(kChanges[0], {0.0});
  if (follow && options.calibrate) {
    consider_all(std::span(kChanges).subspan(1));
    if (!is_verified(best->attempt, attempts, options)) consider_all(kFurtherChanges);
  }
  consider_odometry();
  if (options.repair_slips && follow) repair_slips(readings, directions, options, *best, result);
  result.habits = best->habits;
  result.wall_directions_rad = best->directions_rad;
  result.log_evidence = best->chain.log_evidence;
  result.heading_sigma_rad = by_reading(best->problem, best->chain.sigma_rad);
  result.segments = best->problem.segments.size();
  result.loops_verified = is_verified(best->attempt, attempts, options);
  result.map_from_robot = std::move(best->attempt.map_from_robot);
  begin_at(readings.front().odom_from_robot, result.map_from_robot);
  return result;
}

}  // namespace roomatlas
