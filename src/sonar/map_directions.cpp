// SPDX-License-Identifier: GPL-3.0-or-later
#include "map_directions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "roomatlas/core/pose2.hpp"

namespace roomatlas {
namespace {

constexpr int kTried = 180;      // directions: half a degree apart, finer than walls tell
constexpr int kRefinements = 5;  // of directions by the walls that follow them
using Directions = std::vector<double>;

/// Of a wall that follows a direction: negative log likelihood, but for a constant.
double cost_of(const MapWall& wall, double direction_rad, const MapDirectionsOptions& options) {
  const double sigma = std::hypot(options.wall_sigma_rad, options.end_sigma_m / wall.length_m);
  const double off = wrap_quarter(wall.normal_rad - direction_rad) / sigma;
  const double far = options.far_sigmas * options.far_sigmas;
  return options.share * std::min(1.0, wall.length_m) * std::min(off * off, far) / 2.0;
}

/// The most likely course of directions along the walls.
struct Course {
  std::vector<std::size_t> followed;
  double cost = 0.0;
};

std::size_t cheapest(const std::vector<double>& cost) {
  return static_cast<std::size_t>(std::min_element(cost.begin(), cost.end()) - cost.begin());
}

Course course_of(std::span<const MapWall> walls, std::span<const double> directions_rad,
                 const MapDirectionsOptions& options) {
  const std::size_t count = directions_rad.size();
  std::vector<double> cost(count, 0.0);
  std::vector<std::size_t> before(walls.size() * count);
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const std::size_t best = cheapest(cost);
    const double switched = cost[best] + options.switch_cost;
    for (std::size_t k = 0; k < count; ++k) {
      before[i * count + k] = cost[k] <= switched ? k : best;
      cost[k] = std::min(cost[k], switched) + cost_of(walls[i], directions_rad[k], options);
    }
  }
  Course course;
  course.followed.resize(walls.size());
  std::size_t at = cheapest(cost);
  course.cost = cost[at];
  for (std::size_t i = walls.size(); i-- > 0;) {
    course.followed[i] = at;
    at = before[i * count + at];
  }
  return course;
}

/// Each direction as the mean of the walls that follow it, without those that are far off.
Directions refined(std::span<const MapWall> walls, Directions directions_rad,
                   const MapDirectionsOptions& options) {
  const double far_rad = options.far_sigmas * options.wall_sigma_rad;
  for (int round = 0; round < kRefinements; ++round) {
    const Course course = course_of(walls, directions_rad, options);
    std::vector<double> sum(directions_rad.size(), 0.0);
    std::vector<double> weight(directions_rad.size(), 0.0);
    for (std::size_t i = 0; i < walls.size(); ++i) {
      const std::size_t k = course.followed[i];
      const double off_rad = wrap_quarter(walls[i].normal_rad - directions_rad[k]);
      if (std::abs(off_rad) > far_rad) continue;
      const double own = std::min(1.0, walls[i].length_m);
      sum[k] += own * off_rad;
      weight[k] += own;
    }
    for (std::size_t k = 0; k < directions_rad.size(); ++k) {
      if (weight[k] > 0.0) directions_rad[k] = wrap_quarter(directions_rad[k] + sum[k] / weight[k]);
    }
  }
  return directions_rad;
}

/// The directions, and the one beside them that makes the course most likely.
Directions with_another(std::span<const MapWall> walls, const Directions& directions_rad,
                        const MapDirectionsOptions& options) {
  Directions best_rad = directions_rad;
  double least = std::numeric_limits<double>::max();
  Directions candidate_rad = directions_rad;
  candidate_rad.push_back(0.0);
  for (int i = 0; i < kTried; ++i) {
    const double rad = (static_cast<double>(i) / kTried - 0.5) * kPi / 2.0;
    const bool is_known =
        std::any_of(directions_rad.begin(), directions_rad.end(), [&](double other_rad) {
          return std::abs(wrap_quarter(rad - other_rad)) < options.least_apart_rad;
        });
    if (is_known) continue;
    candidate_rad.back() = rad;
    const double cost = course_of(walls, candidate_rad, options).cost;
    if (cost >= least) continue;
    least = cost;
    best_rad = candidate_rad;
  }
  return refined(walls, std::move(best_rad), options);
}

}  // namespace

std::vector<std::size_t> directions_followed(std::span<const MapWall> walls,
                                             std::span<const double> directions_rad,
                                             const MapDirectionsOptions& options) {
  return course_of(walls, directions_rad, options).followed;
}

double followed_share(std::span<const MapWall> walls, std::span<const double> directions_rad) {
  constexpr double kNearRad = radians(5.0);  // two sigmas of a wall on the map
  const std::vector<std::size_t> followed = directions_followed(walls, directions_rad);
  double near = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const double off_rad = wrap_quarter(walls[i].normal_rad - directions_rad[followed[i]]);
    const double own = std::min(1.0, walls[i].length_m);
    all += own;
    if (std::abs(off_rad) < kNearRad) near += own;
  }
  return near / all;
}

std::vector<double> map_directions(std::span<const MapWall> walls,
                                   const MapDirectionsOptions& options) {
  if (walls.empty()) return {};
  Directions directions_rad = with_another(walls, {}, options);
  double cost = course_of(walls, directions_rad, options).cost;
  while (directions_rad.size() < options.most) {
    Directions more_rad = with_another(walls, directions_rad, options);
    const double less = course_of(walls, more_rad, options).cost;
    if (less > cost - options.least_gain) break;
    directions_rad = std::move(more_rad);
    cost = less;
  }
  return directions_rad;
}

}  // namespace roomatlas
