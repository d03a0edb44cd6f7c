// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/correct/sonar_trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "roomatlas/correct/wall_direction.hpp"
#include "sonar_attempt.hpp"
#include "sonar_repairs.hpp"

namespace roomatlas {
namespace {

using Readings = std::span<const RangeReading>;

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

/// Moves a trajectory so that it begins where odometry does. @return the turn
double begin_at(const Pose2& first, std::vector<Pose2>& poses) {
  const Pose2 moved = first * inverse(poses.front());
  for (Pose2& pose : poses) pose = moved * pose;
  return moved.theta_rad;
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
  const auto offer = [&](Idea idea, std::string name) {
    Attempt attempt =
        solve(readings, directions, idea, std::move(name), idea.chain.correction_rad, options);
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
    offer(std::move(idea), std::move(name));
  };
  const auto consider_odometry = [&] {
    Idea idea = idea_of(readings, directions, {}, 1.0, {0.0}, options);
    std::fill(idea.chain.correction_rad.begin(), idea.chain.correction_rad.end(), 0.0);
    idea.is_odometry = true;
    offer(std::move(idea), "odometry's own heading");
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
  refine(readings, directions, options, *best, result);
  result.habits = best->habits;
  result.habits.length_scale *= best->attempt.length_scale;
  result.wall_directions_rad = best->directions_rad;
  result.log_evidence = best->chain.log_evidence;
  result.heading_sigma_rad = by_reading(best->problem, best->chain.sigma_rad);
  result.segments = best->problem.segments.size();
  result.loops_verified = is_verified(best->attempt, attempts, options);
  result.map_from_robot = std::move(best->attempt.map_from_robot);
  const double turn_rad = begin_at(readings.front().odom_from_robot, result.map_from_robot);
  if (!best->is_odometry) result.walls_rad = wrap_quarter(turn_rad);
  return result;
}

}  // namespace roomatlas
