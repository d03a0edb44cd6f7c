// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

#include "roomatlas/core/for_each_index.hpp"

namespace roomatlas {
namespace {

// Nodes of the heading's chain: farther apart, odometry drifts by more than a state's width between
// them; nearer costs time alone.
constexpr double kChainNodeM = 0.3;
constexpr double kChainNodeRad = 0.25;

// Sigmas of a weak prior at no habits, which decides where the walls do not.
constexpr double kBiasSigma = 2.0;   // degrees a metre
constexpr double kGainSigma = 0.05;  // share of the turns
constexpr double kLagSigmaS = 0.3;
constexpr double kScaleSigma = 0.03;  // share of the lengths

constexpr double kCoarseWayM = 300.0;   // what the first search looks at
constexpr double kEnoughWayM = 1000.0;  // habits do not change: more costs time alone

/// The readings of the first metres of a mission.
std::span<const RangeReading> beginning(std::span<const RangeReading> readings, double enough_m) {
  double way_m = 0.0;
  std::size_t count = 1;
  for (; count < readings.size() && way_m < enough_m; ++count) {
    way_m += (readings[count].odom_from_robot.position() -
              readings[count - 1].odom_from_robot.position())
                 .norm();
  }
  return readings.first(std::min(readings.size(), count));
}

/// Keeps the calibration with the highest score.
class Search {
 public:
  Search(std::span<const RangeReading> readings, const DriveDirections& directions,
         const WallSegmentOptions& segments, const SightingChainOptions& chain,
         const Calibration& start, int jobs)
      : readings_(readings),
        directions_(directions),
        segments_(segments),
        chain_(chain),
        jobs_(jobs),
        best_(start) {
    score_ = score(best_, problem_of(best_, jobs_));
  }

  /// Tries changes of one habit about the best so far.
  void along(double OdometryHabits::*habit, std::initializer_list<double> changes) {
    std::vector<Calibration> candidates(changes.size(), best_);
    std::transform(changes.begin(), changes.end(), candidates.begin(), candidates.begin(),
                   [&](double change, Calibration candidate) {
                     candidate.habits.*habit += change;
                     return candidate;
                   });
    const auto scores = results_of<double>(candidates.size(), jobs_, [&](std::size_t i) {
      return score(candidates[i], problem_of(candidates[i], 1));
    });
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (scores[i] <= score_) continue;
      score_ = scores[i];
      best_ = candidates[i];
    }
  }
  /// Decides anew how much to doubt odometry: more than usual only where that is clearly likelier.
  void doubt(const std::vector<double>& doubts) {
    const HeadingProblem problem = problem_of(best_, jobs_);
    std::vector<Calibration> candidates(1 + doubts.size(), best_);
    candidates[0].doubt = 1.0;
    for (std::size_t i = 0; i < doubts.size(); ++i) candidates[1 + i].doubt = doubts[i];
    const auto scores = results_of<double>(
        candidates.size(), jobs_, [&](std::size_t i) { return score(candidates[i], problem); });
    score_ = scores[0];
    best_ = candidates[0];
    for (std::size_t i = 1; i < candidates.size(); ++i) {
      if (!(scores[i] > score_ && scores[i] > scores[0] + kClearly)) continue;
      score_ = scores[i];
      best_ = candidates[i];
    }
  }
  /// Looks for wings at an angle, so that the habits are not made to bend them.
  void find_directions() {
    const HeadingProblem problem = problem_of(best_, jobs_);
    walls_rad_ = building_directions(problem, best_.doubting(chain_), kClearly, jobs_);
    score_ = score(best_, problem);
  }
  [[nodiscard]] const Calibration& best() const { return best_; }

 private:
  [[nodiscard]] HeadingProblem problem_of(const Calibration& calibration, int jobs) const {
    return heading_problem(readings_, directions_, calibration.habits, segments_, jobs);
  }
  /// Log evidence, with a weak prior against habits.
  /// @param problem of the same habits
  [[nodiscard]] double score(const Calibration& calibration, const HeadingProblem& problem) const {
    const OdometryHabits& habits = calibration.habits;
    const double bias = degrees(habits.bias_rad_per_m) / kBiasSigma;
    const double gain = (habits.turn_gain - 1.0) / kGainSigma;
    const double lag = habits.lag_s / kLagSigmaS;
    const double scale = (habits.length_scale - 1.0) / kScaleSigma;
    return heading_evidence(problem.nodes, problem.sightings, walls_rad_,
                            calibration.doubting(chain_)) -
           (bias * bias + gain * gain + lag * lag + scale * scale) / 2.0;
  }

  std::span<const RangeReading> readings_;
  const DriveDirections& directions_;
  const WallSegmentOptions& segments_;
  const SightingChainOptions& chain_;
  int jobs_;
  std::vector<double> walls_rad_ = {0.0};
  Calibration best_;
  double score_ = 0.0;
};

}  // namespace

HeadingProblem heading_problem(std::span<const RangeReading> readings,
                               const DriveDirections& directions, const OdometryHabits& habits,
                               const WallSegmentOptions& segments, int jobs) {
  HeadingProblem problem;
  problem.path = driven_path(readings, directions, habits);
  const DrivenPath& path = problem.path;
  problem.segments = wall_segments(readings, path.odom_from_robot, path.path_m, segments, jobs);
  problem.node_readings = nodes_along(path, kChainNodeM, kChainNodeRad);
  for (const std::size_t i : problem.node_readings) {
    problem.nodes.push_back({path.path_m[i], path.turned_rad[i]});
  }
  for (const WallSegment& segment : problem.segments) {
    const auto next = std::upper_bound(problem.node_readings.begin(), problem.node_readings.end(),
                                       segment.reading);
    const auto node = static_cast<std::size_t>(next - problem.node_readings.begin()) - 1;
    problem.sightings.push_back(
        {node, wrap_angle(path.odom_from_robot[segment.reading].theta_rad + segment.normal_rad),
         segment.length_m});
  }
  return problem;
}

Calibration calibrate_odometry(std::span<const RangeReading> readings,
                               const DriveDirections& directions,
                               const WallSegmentOptions& segments,
                               const SightingChainOptions& chain, int jobs) {
  // The steps reach as far as the worst recorded logs, 3.3 degrees a metre and a gain of 0.95, and
  // farther: a heading that slips looks for its gain beyond them.
  Search coarse(beginning(readings, kCoarseWayM), directions, segments, chain, {}, jobs);
  const auto deg = [](double value) { return radians(value); };
  coarse.along(
      &OdometryHabits::bias_rad_per_m,
      {deg(-4.0), deg(-3.5), deg(-3.0), deg(-2.5), deg(-2.0), deg(-1.5), deg(-1.0), deg(-0.5),
       deg(0.5), deg(1.0), deg(1.5), deg(2.0), deg(2.5), deg(3.0), deg(3.5), deg(4.0)});
  Search search(beginning(readings, kEnoughWayM), directions, segments, chain, coarse.best(), jobs);
  search.along(&OdometryHabits::bias_rad_per_m, {deg(-0.25), deg(0.25)});
  search.find_directions();
  search.doubt({1.6, 2.4});  // may be the other habits, until they are found
  search.along(&OdometryHabits::turn_gain, {-0.12, -0.08, -0.04, 0.04, 0.08, 0.12});
  search.along(&OdometryHabits::turn_gain, {-0.02, -0.01, 0.01, 0.02});
  search.along(&OdometryHabits::lag_s, {-0.8, -0.6, -0.45, -0.3, -0.2, -0.1, 0.1, 0.2, 0.3});
  search.along(&OdometryHabits::bias_rad_per_m, {deg(-0.25), deg(-0.12), deg(0.12), deg(0.25)});
  search.along(&OdometryHabits::turn_gain, {-0.04, -0.02, 0.02, 0.04});
  search.along(&OdometryHabits::lag_s, {-0.05, 0.05});
  search.doubt({1.6, 2.4});
  return search.best();
}

std::vector<double> building_directions(const HeadingProblem& problem, SightingChainOptions chain,
                                        double clearly, int jobs) {
  chain.states = 90;                  // enough for a comparison
  constexpr std::size_t kMost = 3;    // more would fit anything
  constexpr double kFirstDeg = 10.0;  // nearer ones are one direction, seen with noise
  constexpr double kStepDeg = 5.0;    // a wing's walls are found up to 2.5 degrees beside it
  std::vector<double> tried_rad;
  for (double deg = kFirstDeg; deg <= 90.0 - kFirstDeg; deg += kStepDeg) {
    tried_rad.push_back(radians(deg));
  }
  std::vector<double> directions_rad = {0.0};
  double evidence = heading_evidence(problem.nodes, problem.sightings, directions_rad, chain);
  while (directions_rad.size() < kMost) {
    const auto found = results_of<double>(tried_rad.size(), jobs, [&](std::size_t i) {
      std::vector<double> candidate = directions_rad;
      candidate.push_back(tried_rad[i]);
      return heading_evidence(problem.nodes, problem.sightings, candidate, chain);
    });
    const auto best = std::max_element(found.begin(), found.end());  // the first of equal ones
    if (*best <= evidence + clearly) break;
    directions_rad.push_back(tried_rad[static_cast<std::size_t>(best - found.begin())]);
    evidence = *best;
  }
  return directions_rad;
}

}  // namespace roomatlas
