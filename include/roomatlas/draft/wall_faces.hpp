// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/draft/evidence.hpp"

namespace roomatlas {

/// A stretch along a line, by its positions.
struct Interval {
  double low_m = 0.0;
  double high_m = 0.0;
  [[nodiscard]] double length_m() const { return high_m - low_m; }
};

/// One side of a wall: a straight line, where along it the wall was seen, and from which side.
struct WallFace {
  double normal_rad = 0.0;       ///< towards the side from which it was seen
  double offset_m = 0.0;         ///< of the line from the building's origin, along the normal
  std::vector<Interval> seen;    ///< ascending; along `along()`, with gaps between them
  std::vector<Interval> cover;   ///< where it goes on, seen or hidden: across gaps of doors, across
                                 ///< what nobody saw, up to the next wall; `build_walls` tells
  std::vector<Interval> hidden;  ///< where furniture stands before it; `build_walls` tells
  bool is_closed_behind = true;  ///< its other side was seen near, or nothing for a metre behind
  bool is_furniture = false;     ///< the front of what hides a wall
  bool is_regular = false;       ///< follows a direction of the building
  double prominence_m = 0.0;  ///< metres of wall seen on its line, both faces of a wall together;
                              ///< `build_walls` tells

  [[nodiscard]] Point2 normal() const { return direction(normal_rad); }
  [[nodiscard]] Point2 along() const { return direction(normal_rad + kPi / 2.0); }
  [[nodiscard]] Point2 at(double along_m) const { return offset_m * normal() + along_m * along(); }
  [[nodiscard]] double low_m() const { return seen.front().low_m; }
  [[nodiscard]] double high_m() const { return seen.back().high_m; }
  [[nodiscard]] double support_m() const;  ///< length of all that was seen
};

struct WallFaceOptions {
  double max_turn_deg = 15.0;  ///< of a surface's normal from its wall's; larger mixes walls
  double bin_along_m = 0.1;    ///< where a wall was seen is told this finely
  int min_hits = 3;            ///< in such a piece of wall; fewer are noise
  double max_gap_m = 1.6;      ///< in one face: a door, a cupboard; larger joins different walls
  double min_support_m = 0.3;  ///< of a face along the building's main directions
  double min_wing_support_m = 0.5;     ///< along further ones, and of what sonars heard
  double min_slanted_support_m = 0.5;  ///< along none
  double wing_share = 0.08;            ///< of all surfaces, for a further direction
  int max_wings = 2;
  double snap_m = 0.04;        ///< faces of one direction and side this near are one line ...
  double snap_gap_m = 4.0;     ///< ... when no farther apart along it
  double sonar_range_m = 3.0;  ///< farther echoes say too little about where a wall is
};

/// Where walls are: faces along the building's directions first, by greedy choice of the longest
/// runs of surfaces; then slanted and curved ones as pieces of straight line.
/// @param jobs threads at once, see `for_each_index`
[[nodiscard]] std::vector<WallFace> find_wall_faces(const BuildingEvidence& evidence,
                                                    const WallFaceOptions& options, int jobs = 1);

/// The direction modulo 90 degrees that most surfaces follow, in [0, pi/2).
/// @param surfaces not empty
[[nodiscard]] double main_direction_rad(const std::vector<SurfacePoint>& surfaces);

}  // namespace roomatlas
