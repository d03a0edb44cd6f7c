// SPDX-License-Identifier: GPL-3.0-or-later
// Which stretches of wall are one wall, as the poses stand.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "roomatlas/core/pose2.hpp"

namespace roomatlas {

/// A stretch of wall in the frame of the node at which it was seen.
struct SeenWall {
  std::size_t node = 0;
  double normal_rad = 0.0;
  Point2 middle_node = Point2::Zero();
  double length_m = 0.0;
  double path_m = 0.0;        ///< where on its way the robot saw it
  double sigma_m = 0.0;       ///< of its returns: root mean square of their residuals
  std::size_t direction = 0;  ///< of the building's: the one that it follows
};

/// Two stretches that face the same way and overlap.
struct WallPair {
  std::size_t first = 0;
  std::size_t second = 0;  ///< of the walls; greater than `first`
  double along_m = 0.0;    ///< from the second's middle along it to the middle of the overlap
};

struct WallPairOptions {
  double min_path_m = 1.0;      ///< nearer on the way: the same readings
  double max_turn_rad = 0.175;  ///< between the normals: 10 degrees. Larger pairs a wall with the
                                ///< one that meets it at an angle
  double near_gate_m = 0.1;     ///< across, of two stretches that were seen in one place; larger
                                ///< pairs a cupboard with the wall behind it
  double gate_per_path = 0.04;  ///< and more for each metre of way between them: as far as odometry
                                ///< may have drifted
  double min_overlap_m = 0.1;   ///< at a gate of 0; more loses walls that two visits saw in part
  double overlap_per_gate = 0.5;  ///< less of it is asked the wider the gate, up to 0.4 m
};

/// All pairs within `scale_m` of twice the scale across, by first, then second.
[[nodiscard]] std::vector<WallPair> find_wall_pairs(std::span<const SeenWall> walls,
                                                    std::span<const Pose2> map_from_node,
                                                    double scale_m, const WallPairOptions& options);

}  // namespace roomatlas
