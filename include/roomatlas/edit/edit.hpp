// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

enum class EditKind {
  name_room,
  set_room_kind,
  join_rooms,
  split_room,
  shut_door,
  open_door,
  add_door,
  move_wall,
  furniture_to_wall,
  wall_to_furniture,
  reject_closure,
  pin_visits,
};

/// As it stands in edits.json: "name_room".
[[nodiscard]] const char* to_string(EditKind kind);

/// A room that a statement speaks of. It is the one that lies at the place and, where an outline is
/// told, shares most of it.
struct RoomAnchor {
  std::optional<RoomId> id;  ///< its lasting number; decides alone where there is no place
  std::optional<Point2> at;  ///< building metres, inside of it
  Ring outline;              ///< as it was when the statement was made; may be empty
};

/// What somebody who knows the building says of it. Anchored to places in the building's frame
/// (metres) and to moments of the mission (seconds), so that it holds when the mission is mapped
/// again. Fields beside `kind` are those that its kind needs.
struct Edit {
  EditKind kind = EditKind::name_room;
  std::vector<RoomAnchor> rooms;        ///< two of `join_rooms`, one of what else is of a room
  std::string name;                     ///< of `name_room`
  RoomKind room_kind = RoomKind::room;  ///< of `set_room_kind`
  Segment2 line;                        ///< the cut, the new door's jambs, or the wall
  Point2 at = Point2::Zero();           ///< of a door or furniture, within `kEditReach_m`
  Ring outline;                         ///< of `wall_to_furniture`; empty: a room's hole at `at`
  double by_m = 0.0;         ///< of `move_wall`: to the left of its line; right where negative
  double thickness_m = 0.0;  ///< of `split_room`: of the wall between; 0: the rooms stay open
  double from_time_s = 0.0;  ///< of closures: when the robot was in the one visit ...
  double to_time_s = 0.0;    ///< ... and in the other, by the log's clock
  Pose2 from_from_to;        ///< of `pin_visits`: the frame of the second visit in the first's
};

constexpr double kEditReach_m = 0.5;  ///< a door or piece of furniture is found this near: maps of
                                      ///< one log differ by less, and doors lie farther apart

/// Rooms told by their number alone get place and outline of those of the plan; numbers that the
/// plan does not have stay without a place.
[[nodiscard]] std::vector<Edit> with_places(std::vector<Edit> edits,
                                            const std::vector<PlanRoom>& rooms);

/// The anchor of a room of a plan.
[[nodiscard]] RoomAnchor anchor_of(const PlanRoom& room);

/// A statement that does not fit the building any more, or has no effect.
/// @param index of the statement in its list
[[nodiscard]] Issue edit_issue(std::size_t index, const Edit& edit, const std::string& why,
                               Severity severity = Severity::warning);

}  // namespace roomatlas
