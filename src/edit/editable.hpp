// SPDX-License-Identifier: GPL-3.0-or-later
// A building that statements are applied to. Private.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "roomatlas/edit/edit.hpp"
#include "roomatlas/rooms/mapped_building.hpp"

namespace roomatlas::edit {

/// Why a statement was not applied; empty where it was.
using Why = std::string;

inline constexpr double kThickestWall_m = 0.8;  ///< that a door goes through

using Shapes = std::vector<Polygon>;  ///< disjoint, of one room

/// What a room covers: the union of its outlines, the largest first.
[[nodiscard]] Shapes shapes_of(const std::vector<PlacedOutline>& outlines, RoomId room);

/// Replaces the outlines of a room. Its edges follow: what lies on an edge that was there keeps
/// that one's evidence, the rest is inferred.
void set_shapes(MappedBuilding& building, RoomId room, const Shapes& shapes);

/// The edges of a room with new shapes, of those that there were.
[[nodiscard]] std::vector<PlanEdge> refitted(RoomId room, const Shapes& shapes,
                                             const std::vector<PlanEdge>& were);

[[nodiscard]] double area_of(const Shapes& shapes);
[[nodiscard]] bool covers(const Shapes& shapes, const Point2& point);

/// The rectangle about a segment, so far to the left and right of it and beyond both ends.
[[nodiscard]] Polygon band(const Segment2& line, double left_m, double right_m, double beyond_m);

/// The unit vector to the left of a segment.
[[nodiscard]] Point2 left_of(const Segment2& line);

/// The room that the anchor means, or why there is none.
struct FoundRoom {
  RoomId room = 0;
  Why why;
};
[[nodiscard]] FoundRoom find_room(const MappedBuilding& building, const RoomAnchor& anchor);

[[nodiscard]] Why join_rooms(const Edit& edit, MappedBuilding& building);
[[nodiscard]] Why split_room(const Edit& edit, MappedBuilding& building);
[[nodiscard]] Why shut_door(const Edit& edit, MappedBuilding& building);
[[nodiscard]] Why open_door(const Edit& edit, MappedBuilding& building);
[[nodiscard]] Why add_door(const Edit& edit, MappedBuilding& building);
[[nodiscard]] Why move_wall(const Edit& edit, MappedBuilding& building);
[[nodiscard]] Why furniture_to_wall(const Edit& edit, MappedBuilding& building);
[[nodiscard]] Why wall_to_furniture(const Edit& edit, MappedBuilding& building);

}  // namespace roomatlas::edit
