// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "obstacles.hpp"
#include "roomatlas/core/geometry.hpp"
#include "roomatlas/simulate/furnish.hpp"

namespace roomatlas {

/// The rectangle from (min_x, min_y) to (max_x, max_y) of a frame, in the world; counter-clockwise.
[[nodiscard]] Ring rectangle_in(const Pose2& world_from_frame, const Point2& min,
                                const Point2& max);

/// What stands in a building while it is furnished, and what must stay clear.
class FurnishSite {
 public:
  FurnishSite(const FloorPlan& world, const FurnishOptions& options);

  /// Whether a convex piece would overlap nothing, and keeps clear of doors and of the route.
  [[nodiscard]] bool has_place_for(const Ring& outline) const;
  /// The same for the leaf of a door, which may be near to doors.
  [[nodiscard]] bool has_place_for_leaf(const Ring& outline) const;
  /// How far ahead of the line y = 0 the wall along it comes, for a piece from x = 0 to `length_m`
  /// that looks along y. Nothing where there is no wall behind most of its back.
  [[nodiscard]] std::optional<double> wall_face_m(const Pose2& world_from_line,
                                                  double length_m) const;
  void add(const Ring& outline);

 private:
  [[nodiscard]] bool meets_wall(const Ring& outline) const;
  [[nodiscard]] bool meets_piece(const Ring& outline) const;
  [[nodiscard]] bool is_on_route(const Ring& outline) const;
  [[nodiscard]] bool is_at_door(const Ring& outline) const;

  double door_clearance_m_;
  double route_clearance_m_;
  std::vector<Polygon> walls_;
  std::vector<Box2> wall_boxes_;
  ObstacleIndex wall_index_;
  std::vector<Ring> pieces_;  ///< with what stood there before
  std::vector<Box2> piece_boxes_;
  std::vector<Segment2> doors_;  ///< what must stay clear around
  std::vector<Segment2> route_;
};

}  // namespace roomatlas
