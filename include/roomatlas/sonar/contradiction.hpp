// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/mission/mission.hpp"
#include "roomatlas/sonar/wall_segments.hpp"

namespace roomatlas {

struct ContradictionOptions {
  double cell_m = 0.1;             ///< larger takes a ray along a wall for one through it
  double sample_m = 0.1;           ///< along walls; larger misses cells, smaller costs time
  double ray_step_m = 0.15;        ///< of the robot, between readings that are looked at; smaller
                                   ///< costs time
  double max_range_m = 3.0;        ///< of a return whose ray frees cells; a longer one is a cone
                                   ///< more than a metre wide
  double short_of_return_m = 0.3;  ///< where its ray ends; nearer, it frees the wall that it hit
  double same_visit_m = 10.0;      ///< of way: nearer, walls and rays share their pose error
};

/// What the visits of a mission say of each other's walls. Without walls all is 0.
struct Contradiction {
  double confirmed_m = 0.0;     ///< of wall that another visit heard too
  double contradicted_m = 0.0;  ///< of wall that no other visit heard and at least two rays crossed
  // The same of the walls that each reading heard, one a reading.
  std::vector<double> confirmed_of_reading_m;
  std::vector<double> contradicted_of_reading_m;

  [[nodiscard]] double compared_m() const { return confirmed_m + contradicted_m; }
  /// [0, 1]; negative where nothing could be compared.
  [[nodiscard]] double share() const {
    return compared_m() > 0.0 ? contradicted_m / compared_m() : -1.0;
  }
};

/// Judges poses without truth: walls that one visit heard and others looked through. Doors,
/// people and wide cones leave some of it however good the poses are.
/// @param map_from_robot,path_m one a reading
[[nodiscard]] Contradiction contradiction_of(std::span<const RangeReading> readings,
                                             std::span<const Pose2> map_from_robot,
                                             std::span<const double> path_m,
                                             std::span<const WallSegment> segments,
                                             const ContradictionOptions& options);

}  // namespace roomatlas
