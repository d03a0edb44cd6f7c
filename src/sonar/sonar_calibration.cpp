// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

namespace roomatlas {
namespace {

// Nodes of the heading's chain: farther apart, odometry drifts by more than a state's width between
// them; nearer costs time alone.
constexpr double kNodeM = 0.3;
constexpr double kNodeRad = 0.25;

constexpr double kClearly = 10.0;  // of log evidence, that another direction of the building or
                                   // more doubt must bring; less is found in noise

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
         const Calibration& start)
      : readings_(readings),
        directions_(directions),
        segments_(segments),
        chain_(chain),
        best_(start) {
    score_ = score(best_);
  }

  /// Tries changes of one habit about the best so far.
  void along(double OdometryHabits::*habit, std::initializer_list<double> changes) {
    const Calibration around = best_;
    for (const double change : changes) {
      Calibration candidate = around;
      candidate.habits.*habit += change;
      const double now = score(candidate);
      if (now <= score_) continue;
      score_ = now;
      best_ = candidate;
    }
  }
  /// Decides anew how much to doubt odometry: more than usual only where that is clearly likelier.
  void doubt(std::initializer_list<double> doubts) {
    best_.doubt = 1.0;
    score_ = score(best_);
    const double as_usual = score_;
    for (const double doubt : doubts) {
      Calibration candidate = best_;
      candidate.doubt = doubt;
      const double now = score(candidate);
      if (now > score_ && now > as_usual + kClearly) {
        score_ = now;
        best_ = candidate;
      }
    }
  }
  /// Looks for wings at an angle, so that the habits are not made to bend them.
  void find_directions() {
    const HeadingProblem problem = heading_problem(readings_, directions_, best_.habits, segments_);
    walls_rad_ = building_directions(problem, best_.doubting(chain_));
    score_ = score(best_);
  }
  [[nodiscard]] const Calibration& best() const { return best_; }

 private:
  /// Log evidence, with a weak prior against habits.
  [[nodiscard]] double score(const Calibration& calibration) const {
    const OdometryHabits& habits = calibration.habits;
    const HeadingProblem problem = heading_problem(readings_, directions_, habits, segments_);
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
  std::vector<double> walls_rad_ = {0.0};
  Calibration best_;
  double score_ = 0.0;
};

}  // namespace

HeadingProblem heading_problem(std::span<const RangeReading> readings,
                               const DriveDirections& directions, const OdometryHabits& habits,
                               const WallSegmentOptions& segments) {
  HeadingProblem problem;
  problem.path = driven_path(readings, directions, habits);
  const DrivenPath& path = problem.path;
  problem.segments = wall_segments(readings, path.odom_from_robot, path.path_m, segments);
  problem.node_readings = nodes_along(path, kNodeM, kNodeRad);
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
                               const SightingChainOptions& chain) {
  // The steps reach as far as the worst recorded logs, 3.3 degrees a metre and a gain of 0.95, and
  // farther: a heading that slips looks for its gain beyond them.
  Search coarse(beginning(readings, kCoarseWayM), directions, segments, chain, {});
  const auto deg = [](double value) { return radians(value); };
  coarse.along(
      &OdometryHabits::bias_rad_per_m,
      {deg(-4.0), deg(-3.5), deg(-3.0), deg(-2.5), deg(-2.0), deg(-1.5), deg(-1.0), deg(-0.5),
       deg(0.5), deg(1.0), deg(1.5), deg(2.0), deg(2.5), deg(3.0), deg(3.5), deg(4.0)});
  Search search(beginning(readings, kEnoughWayM), directions, segments, chain, coarse.best());
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

std::vector<double> building_directions(const HeadingProblem& problem, SightingChainOptions chain) {
  chain.states = 90;                  // enough for a comparison
  constexpr std::size_t kMost = 3;    // more would fit anything
  constexpr double kFirstDeg = 10.0;  // nearer ones are one direction, seen with noise
  constexpr double kStepDeg = 5.0;    // a wing's walls are found up to 2.5 degrees beside it
  std::vector<double> directions_rad = {0.0};
  double evidence = heading_evidence(problem.nodes, problem.sightings, directions_rad, chain);
  while (directions_rad.size() < kMost) {
    double best = evidence + kClearly;
    std::optional<double> another_rad;
    for (double deg = kFirstDeg; deg <= 90.0 - kFirstDeg; deg += kStepDeg) {
      std::vector<double> candidate = directions_rad;
      candidate.push_back(radians(deg));
      const double now = heading_evidence(problem.nodes, problem.sightings, candidate, chain);
      if (now <= best) continue;
      best = now;
      another_rad = radians(deg);
    }
    if (!another_rad) break;
    directions_rad.push_back(*another_rad);
    evidence = best;
  }
  return directions_rad;
}

}  // namespace roomatlas
