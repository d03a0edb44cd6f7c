// SPDX-License-Identifier: GPL-3.0-or-later
#include "steering.hpp"

#include "roomatlas/grid/polar_histogram.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomatlas {
namespace {

constexpr double kLookAheadM = 0.45;     // along the way; more cuts corners
constexpr double kWindowM = 0.9;         // of the polar histogram; more shies from far walls
constexpr double kSectorDeg = 5.0;
constexpr double kMaxDeviationDeg = 30.0;
constexpr double kDensityOfWall = 1000.0;  // k that weighs like a deviation of 30 degrees
constexpr double kTurnOnSpotDeg = 30.0;
constexpr double kMarginM = 0.03;
constexpr double kBackOffM = 0.02;
constexpr double kNearHitM = 0.8;

/// The point of the way some distance ahead of the way's point nearest to the robot.
Point2 look_ahead(const Polyline& way, const Point2& position) {
  const auto nearest = std::min_element(way.begin(), way.end(), [&](const auto& a, const auto& b) {
    return (a - position).squaredNorm() < (b - position).squaredNorm();
  });
  double length_m = 0.0;
  auto at = nearest;
  for (; std::next(at) != way.end() && length_m < kLookAheadM; ++at) {
    length_m += (*std::next(at) - *at).norm();
  }
  return *at;
}

/// The direction near `wanted_rad` with low values of k.
double open_direction(const ExplorerMap& map, const Point2& position, double wanted_rad) {
  const std::vector<double> k = polar_histogram(map.himm(), position, {kSectorDeg, kWindowM});
  const int count = static_cast<int>(k.size());
  const int spread = static_cast<int>(kMaxDeviationDeg / kSectorDeg);
  const auto density = [&](double bearing_rad) {
    const int middle = static_cast<int>(std::floor(degrees(bearing_rad) / kSectorDeg));
    double sum = 0.0;
    for (int i = middle - 1; i <= middle + 1; ++i) {
      sum += k[static_cast<std::size_t>(((i % count) + count) % count)];
    }
    return sum / 3.0;
  };
  double best_rad = wanted_rad;
  double least = std::numeric_limits<double>::infinity();
  for (int i = -spread; i <= spread; ++i) {
    const double bearing_rad = wanted_rad + radians(i * kSectorDeg);
    const double cost =
        std::abs(i) * kSectorDeg / kMaxDeviationDeg + density(bearing_rad) / kDensityOfWall;
    if (cost >= least) continue;
    least = cost;
    best_rad = bearing_rad;
  }
  return best_rad;
}

}  // namespace

std::vector<Point2> near_hits(const RangeReading& reading, const Pose2& map_from_robot) {
  std::vector<Point2> hits;
  for (std::size_t i = 0; i < reading.ranges_m.size(); ++i) {
    const double range_m = reading.ranges_m[i];
    if (!(range_m > 0.0) || range_m >= std::min(kNearHitM, reading.sensor->max_range_m)) continue;
    hits.push_back(map_from_robot * (reading.sensor->robot_from_beam[i] * Point2(range_m, 0.0)));
  }
  return hits;
}

Steering steer(const ExplorerMap& map, const std::vector<Point2>& hits_map,
               const Pose2& map_from_robot, const RobotFootprint& footprint, const Polyline& way,
               const SteeringLimits& limits) {
  if (way.empty()) return {};
  const auto is_clear = [&](const Steering& step) {
    const Pose2 moved = map_from_robot * Pose2{0.0, 0.0, step.turn_rad} *
                        Pose2{step.length_m, 0.0, 0.0};
    if (map.would_touch(moved, kMarginM)) return false;
    const Pose2 robot_from_map = inverse(moved);
    return std::none_of(hits_map.begin(), hits_map.end(), [&](const Point2& hit) {
      const Point2 at = robot_from_map * hit;
      return std::abs(at.x()) <= footprint.length_m / 2.0 + kMarginM &&
             std::abs(at.y()) <= footprint.width_m / 2.0 + kMarginM;
    });
  };

  const Point2 position = map_from_robot.position();
  const Point2 ahead = look_ahead(way, position) - position;
  const double wanted_rad =
      open_direction(map, position, std::atan2(ahead.y(), ahead.x()));
  const double error_rad = wrap_angle(wanted_rad - map_from_robot.theta_rad);
  const double turn_rad = std::clamp(error_rad, -limits.max_turn_rad, limits.max_turn_rad);
  const double misfit = std::abs(error_rad) / radians(kTurnOnSpotDeg);
  const double length_m = misfit >= 1.0 ? 0.0 : limits.max_length_m * (1.0 - 0.7 * misfit);

  const Steering wanted{turn_rad, length_m};
  const Steering slower{turn_rad, length_m / 3.0};
  const Steering on_spot{turn_rad, 0.0};
  const Steering straight{0.0, length_m / 3.0};
  const Steering other_way{-std::copysign(limits.max_turn_rad, error_rad), 0.0};
  const Steering back{0.0, -std::min(kBackOffM, limits.max_length_m)};
  for (const Steering& step : {wanted, slower, on_spot, straight, back, other_way}) {
    const bool moves = step.length_m != 0.0 || std::abs(step.turn_rad) > 1e-3;
    if (moves && is_clear(step)) return step;
  }
  return {};
}

}  // namespace roomatlas
