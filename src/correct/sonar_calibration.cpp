// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_calibration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

namespace roomatlas {
namespace {

constexpr double kNodeM = 0.3;
constexpr double kNodeRad = 0.25;
constexpr std::array kOneDirection = {0.0};

/// How many readings the first search looks at: as many as hold some hundred metres of way.
std::size_t coarse_readings(std::span<const RangeReading> readings) {
  constexpr double kEnoughM = 300.0;
  double way_m = 0.0;
  std::size_t count = 1;
  for (; count < readings.size() && way_m < kEnoughM; ++count) {
    way_m += (readings[count].odom_from_robot.position() -
              readings[count - 1].odom_from_robot.position())
                 .norm();
  }
  return count;
}

/// Keeps the habits with the highest score.
class Search {
 public:
  Search(std::span<const RangeReading> readings, const DriveDirections& directions,
         const WallSegmentOptions& segments, const HeadingChainOptions& chain,
         const OdometryHabits& start)
      : readings_(readings),
        directions_(directions),
        segments_(segments),
        chain_(chain),
        best_(start) {
    score_ = score(best_);
  }

  /// Tries changes of one habit about the best so far.
  void along(double OdometryHabits::*habit, std::initializer_list<double> changes) {
    const OdometryHabits around = best_;
    for (const double change : changes) {
      OdometryHabits candidate = around;
      candidate.*habit += change;
      const double now = score(candidate);
      if (now <= score_) continue;
      score_ = now;
      best_ = candidate;
    }
  }
  [[nodiscard]] const OdometryHabits& best() const { return best_; }

 private:
  /// Log evidence, with a weak prior against habits.
  [[nodiscard]] double score(const OdometryHabits& habits) const {
    const HeadingProblem problem = heading_problem(readings_, directions_, habits, segments_);
    const double bias = degrees(habits.bias_rad_per_m) / 2.0;
    const double gain = (habits.turn_gain - 1.0) / 0.03;
    const double lag = habits.lag_s / 0.3;
    const double scale = (habits.length_scale - 1.0) / 0.03;
    return heading_evidence(problem.nodes, problem.sightings, kOneDirection, chain_) -
           (bias * bias + gain * gain + lag * lag + scale * scale) / 2.0;
  }

  std::span<const RangeReading> readings_;
  const DriveDirections& directions_;
  const WallSegmentOptions& segments_;
  const HeadingChainOptions& chain_;
  OdometryHabits best_;
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

OdometryHabits calibrate_odometry(std::span<const RangeReading> readings,
                                  const DriveDirections& directions,
                                  const WallSegmentOptions& segments,
                                  const HeadingChainOptions& chain) {
  const auto beginning = readings.first(std::min(readings.size(), coarse_readings(readings)));
  Search coarse(beginning, directions, segments, chain, {});
  const auto deg = [](double value) { return radians(value); };
  coarse.along(
      &OdometryHabits::bias_rad_per_m,
      {deg(-4.0), deg(-3.5), deg(-3.0), deg(-2.5), deg(-2.0), deg(-1.5), deg(-1.0), deg(-0.5),
       deg(0.5), deg(1.0), deg(1.5), deg(2.0), deg(2.5), deg(3.0), deg(3.5), deg(4.0)});
  Search search(readings, directions, segments, chain, coarse.best());
  search.along(&OdometryHabits::bias_rad_per_m, {deg(-0.25), deg(0.25)});
  search.along(&OdometryHabits::turn_gain, {-0.06, -0.04, -0.02, 0.02, 0.04, 0.06});
  search.along(&OdometryHabits::turn_gain, {-0.01, 0.01});
  search.along(&OdometryHabits::lag_s, {-0.8, -0.6, -0.45, -0.3, -0.2, -0.1, 0.1, 0.2, 0.3});
  search.along(&OdometryHabits::bias_rad_per_m, {deg(-0.25), deg(-0.12), deg(0.12), deg(0.25)});
  return search.best();
}

}  // namespace roomatlas
