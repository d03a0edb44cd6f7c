// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/core/pose2.hpp"
#include "roomatlas/plan/ids.hpp"

namespace roomatlas {

// One door, from the first sight of it to its symbol on the plan; each step adds to the one before:
//   Doorway    a gap between two jambs               seen by the online stage, or on the whole map
//   Exit       + who left or entered there           asr/asr.hpp: pivots of the paper
//   Door       + the rooms on its two sides          rooms/: decided on all evidence
//   PlanDoor   + its number and its hole in the wall floor_plan.hpp: what is drawn and stored

/// A gap between two jambs, in the frame of what it was found in: a room's grid, an ASR or the
/// building.
struct Doorway {
  Pose2 frame_from_pivot;  ///< mid-point; theta is the way through it, one of two
  double width_m = 0.0;    ///< jamb to jamb
  Segment2 jambs;          ///< a left, b right of the way
};

/// The doorway between two jambs, heading one of the two ways through.
[[nodiscard]] inline Doorway doorway_between(const Segment2& jambs, double heading_rad) {
  const Point2 middle = (jambs.a + jambs.b) / 2.0;
  return {{middle.x(), middle.y(), heading_rad}, (jambs.a - jambs.b).norm(), jambs};
}

/// The same, heading the way that has jamb a on its left.
[[nodiscard]] inline Doorway doorway_between(const Segment2& jambs) {
  const Point2 across = jambs.b - jambs.a;
  return doorway_between(jambs, std::atan2(across.x(), -across.y()));
}

/// The doorway of a width at a pivot, its jambs square to the way.
[[nodiscard]] inline Doorway doorway_at(const Pose2& frame_from_pivot, double width_m) {
  const Point2 half(0.0, width_m / 2.0);
  return {frame_from_pivot, width_m, {frame_from_pivot * half, frame_from_pivot * Point2(-half)}};
}

enum class DoorKind {
  door,     ///< a gap of a door's width, with a leaf or without
  passage,  ///< wider: rooms that go over into each other
  window,   ///< looked through and never driven through: glass, or a hatch
};

[[nodiscard]] const char* to_string(DoorKind kind);

/// A doorway of the building and what it joins; building metres.
struct Door : Doorway {
  std::optional<RoomId> room_a;  ///< the room against its way; none where the robot was not
  std::optional<RoomId> room_b;  ///< the room ahead
  bool is_driven = false;        ///< the robot went through it
  std::vector<AsrId> crossings;  ///< the ASRs that begin at it, where they are known
  DoorKind kind = DoorKind::door;
  std::optional<Segment2> leaf;  ///< as it stood, where it was seen open: hinge to free end

  /// False for a window, or an opening into what was not entered.
  [[nodiscard]] bool is_between_rooms() const { return room_a && room_b; }
};

/// A door of which the jambs and the rooms are known.
[[nodiscard]] inline Door door_between(const Segment2& jambs, std::optional<RoomId> room_a,
                                       std::optional<RoomId> room_b) {
  return {doorway_between(jambs), room_a, room_b, false, {}, DoorKind::door, std::nullopt};
}

}  // namespace roomatlas
