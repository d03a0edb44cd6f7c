// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

/// Where one beam ended.
struct ScanPoint {
  Point2 position = Point2::Zero();
  Point2 normal = Point2::Zero();  ///< unit, towards the sensor; zero where it is not known
  bool is_hit = false;             ///< false: free space was seen up to here, nothing more
};

/// A laser sweep as points in the robot's frame, with the directions of the surfaces.
struct Scan {
  /// Of a reading of several lasers, where one after the first begins.
  struct Further {
    std::size_t first_point = 0;
    Point2 sensor = Point2::Zero();
  };
  Point2 sensor = Point2::Zero();  ///< where the rays begin
  std::vector<ScanPoint> points;   ///< in the order of the beams
  std::vector<Further> further{};  ///< by their points
};

struct ScanOptions {
  double max_hit_m = 20.0;          ///< farther returns end in free space
  double min_range_m = 0.1;         ///< nearer returns are the robot itself
  double no_echo_m = 49.0;          ///< at or beyond it nothing came back: no ray at all
  int normal_neighbors = 5;         ///< beams on each side that tell the surface's direction ...
  double normal_gap_m = 0.25;       ///< ... as long as they lie this near to each other
  double fine_rad = radians(0.75);  ///< of a laser whose beams are less apart, five of them span
                                    ///< less than their ranges err where a wall is near: more are
                                    ///< taken ...
  double fine_reach_m = 0.15;       ///< ... until they reach this far. Larger rounds off corners
};

/// @returns the sweep; empty for a sensor without beams
[[nodiscard]] Scan scan_of(const RangeReading& reading, const ScanOptions& options);

/// Every n-th point, so that at most about `max_points` are left.
[[nodiscard]] std::vector<ScanPoint> thinned(const std::vector<ScanPoint>& points, int max_points);

}  // namespace roomatlas
