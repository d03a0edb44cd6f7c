// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <vector>

#include "roomatlas/match/scan.hpp"

namespace roomatlas {

struct RecentSweepsOptions {
  int few_beams = 130;        ///< a sweep of fewer tells too little of the walls by itself
  int kept = 25;              ///< sweeps; more reach back to where odometry's drift shows
  double apart_m = 0.02;      ///< one after less motion than this ...
  double apart_rad = 0.02;    ///< ... and turn tells nothing new
  double surface_m = 0.35;    ///< points of the same surface lie this near to each other
  int min_points = 5;         ///< fewer tell no direction
  double max_flatness = 0.1;  ///< variance across the surface over that along it
};

/// The last sweeps of a laser with few beams, taken as one: neighbouring beams of a single sweep
/// are too far apart to tell which way a wall runs, but those of several sweeps lie close together.
class RecentSweeps {
 public:
  explicit RecentSweeps(const RecentSweepsOptions& options) : options_(options) {}

  /// Whether sweeps of this sensor need others beside them.
  [[nodiscard]] bool are_needed(const RangeSensor& sensor) const {
    return sensor.robot_from_beam.size() < static_cast<std::size_t>(options_.few_beams);
  }

  void clear() { sweeps_.clear(); }
  /// @param map_from_robot in a frame that all sweeps share until `clear`
  void add(const Scan& scan, const Pose2& map_from_robot);

  /// Gives each point that has no direction that of the surface which it and the points of the last
  /// sweeps near it lie on.
  void add_normals(Scan& scan, const Pose2& map_from_robot) const;

 private:
  struct Sweep {
    Pose2 map_from_robot;
    std::vector<Point2> hits_map;
  };

  RecentSweepsOptions options_;
  std::deque<Sweep> sweeps_;  ///< the newest last
};

}  // namespace roomatlas
