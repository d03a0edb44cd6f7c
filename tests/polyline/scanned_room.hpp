// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/grid/himm_grid.hpp"

namespace roomatlas::testing_polyline {

/// A fan of beams across `fan_rad` ahead of the robot, with normal noise on each range.
struct Scanner {
  int beams = 181;
  double fan_rad = kPi;
  double noise_m = 0.0;
  double max_range_m = 5.0;
  std::uint32_t seed = 1;
};

inline double range_to(const std::vector<Segment2>& walls, const Segment2& beam) {
  double nearest = 1.0;
  for (const Segment2& wall : walls) {
    if (const auto t = crossing_fraction(beam, wall)) nearest = std::min(nearest, *t);
  }
  return nearest * (beam.b - beam.a).norm();
}

/// The grid after driving along `drive` with a scan every 0.1 m.
inline HimmGrid scanned(const std::vector<Segment2>& walls, const Polyline& drive,
                        const Scanner& scanner, const RobotFootprint& footprint = {}) {
  HimmGrid grid(0.1);
  std::mt19937 random(scanner.seed);
  std::normal_distribution<double> noise(0.0, scanner.noise_m > 0.0 ? scanner.noise_m : 1e-12);
  for (std::size_t leg = 1; leg < drive.size(); ++leg) {
    const Point2 along = drive[leg] - drive[leg - 1];
    const double heading = std::atan2(along.y(), along.x());
    const int steps = static_cast<int>(std::ceil(along.norm() / 0.1));
    for (int i = 0; i < steps; ++i) {
      const Point2 at = drive[leg - 1] + along * i / steps;
      std::vector<Ray> rays;
      for (int beam = 0; beam < scanner.beams; ++beam) {
        const double bearing =
            heading + scanner.fan_rad * (static_cast<double>(beam) / (scanner.beams - 1) - 0.5);
        const Point2 farthest = at + scanner.max_range_m * direction(bearing);
        const double range_m = range_to(walls, {at, farthest});
        const bool is_hit = range_m < scanner.max_range_m;
        const double read_m = is_hit ? range_m + noise(random) : range_m;
        rays.push_back({{at, at + read_m * direction(bearing)}, is_hit});
      }
      grid.add_sweep(rays);
      grid.mark_robot({at.x(), at.y(), heading}, footprint);
    }
  }
  return grid;
}

inline void add_chain(std::vector<Segment2>& walls, const Polyline& chain) {
  for (std::size_t i = 1; i < chain.size(); ++i) walls.push_back({chain[i - 1], chain[i]});
}

/// An office of 7 x 5 m with a slanted corner, a niche, a column, four table legs and a door
/// from x = 7 into a corridor.
inline std::vector<Segment2> office_walls() {
  std::vector<Segment2> walls;
  add_chain(walls, {{7, 2},
                    {7, 0},
                    {3.2, 0},
                    {3.2, -0.8},
                    {2.3, -0.8},
                    {2.3, 0},
                    {0, 0},
                    {0, 3.7},
                    {1.2, 5},
                    {7, 5},
                    {7, 3}});
  add_chain(walls, {{4, 3}, {4.4, 3}, {4.4, 3.4}, {4, 3.4}, {4, 3}});
  for (const Point2& leg : Polyline{{1.2, 1.0}, {2.0, 1.0}, {1.2, 1.8}, {2.0, 1.8}}) {
    add_chain(walls,
              {leg, leg + Point2(0.06, 0), leg + Point2(0.06, 0.06), leg + Point2(0, 0.06), leg});
  }
  add_chain(walls, {{8.6, -3}, {8.6, 8}});
  add_chain(walls, {{7.15, 3}, {7.15, 8}});
  add_chain(walls, {{7.15, 2}, {7.15, -3}});
  return walls;
}

inline Polyline office_drive() {
  return {{3.0, 0.8}, {5.8, 0.9}, {5.9, 4.1}, {2.6, 4.0}, {2.7, 2.5}, {6.0, 2.5}, {7.6, 2.5}};
}

}  // namespace roomatlas::testing_polyline
