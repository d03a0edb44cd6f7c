// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/draft/walls.hpp"
#include "roomatlas/rooms/building_grid.hpp"

namespace roomatlas {

constexpr double kLongestStub_m = 0.7;  // of wall beside a door, too short for sonars to hear

/// Tells openings in walls from gaps between pieces of furniture.
class WallOpenings {
 public:
  /// @param is_wall parallel to the faces: which are walls for certain
  /// @param bare the floor without furniture
  /// @param heard what was heard, furniture and all
  WallOpenings(const Walls& walls, const std::vector<bool>& is_wall, const Occupancy& bare,
               const BuildingGrid& heard);

  /// Whether a wall goes on beyond both jambs: on the line of one that is known, up to the next
  /// wall that crosses it; or across a corridor; or as straight obstacles, where a wall follows no
  /// direction of the building.
  [[nodiscard]] bool is_in_wall(const Segment2& jambs) const;

  /// The opening on the line through the obstacles beside it, where these are a wall.
  [[nodiscard]] bool is_among_obstacles(const Segment2& jambs) const;
  [[nodiscard]] Segment2 on_line_of_obstacles(const Segment2& jambs) const;

 private:
  enum class Beside { floor, crossing, stub, wall };

  [[nodiscard]] bool is_on_line_of(const WallFace& face, const Segment2& jambs) const;
  [[nodiscard]] Beside beside(const WallFace& face, double jamb_m, double sign) const;
  [[nodiscard]] double to_crossing_m(const WallFace& face, double jamb_m, double sign) const;
  [[nodiscard]] bool is_solid(const WallFace& face, double along_m) const;
  [[nodiscard]] bool is_across_corridor(const Segment2& jambs) const;
  [[nodiscard]] double obstacles_m(const Point2& jamb, const Point2& along) const;

  const Walls& walls_;
  const std::vector<bool>& is_wall_;
  const Occupancy& bare_;
  const BuildingGrid& heard_;
};

}  // namespace roomatlas
