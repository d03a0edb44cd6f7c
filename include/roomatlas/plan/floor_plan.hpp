// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/plan/door.hpp"
#include "roomatlas/plan/ids.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace roomatlas {

enum class RoomKind { room, corridor, hall };

[[nodiscard]] const char* to_string(RoomKind kind);

/// Of a room's name in bytes; a longer one is no label.
constexpr std::size_t kLongestRoomName = 200;

/// One place of the building. All coordinates are building metres.
struct PlanRoom {
  RoomId id = 0;
  std::string name;  ///< shown on the plan; the number where nobody named it
  RoomKind kind = RoomKind::room;
  std::vector<Polygon> parts;  ///< disjoint, with holes; usually one, the largest first
  double area_m2 = 0.0;
  Point2 label_point = Point2::Zero();  ///< well inside the largest part
  std::vector<AsrId> asrs;              ///< the visits that make it up; empty in a world
};

struct PlanDoor {
  std::int64_t id = 0;
  Segment2 jambs;  ///< the door line
  double width_m = 0.0;
  Ring opening;                  ///< the hole in the wall, four corners
  std::optional<RoomId> room_a;  ///< the rooms on its two sides, where known; room_a < room_b
  std::optional<RoomId> room_b;
  DoorKind kind = DoorKind::door;
  std::optional<Segment2> leaf = std::nullopt;  ///< as it stands, where seen open: hinge to end
};

/// What speaks for a stretch of a room's edge.
enum class WallEvidence {
  measured,    ///< readings ended along it
  inferred,    ///< a wall that is seen beyond goes on here: behind furniture, across what is unseen
  unexplored,  ///< neither: what was seen ends here
};

[[nodiscard]] const char* to_string(WallEvidence evidence);

/// A straight stretch of a room's edge with one answer to what speaks for it.
struct PlanEdge {
  RoomId room = 0;
  Segment2 line;  ///< the room lies to its left
  WallEvidence evidence = WallEvidence::measured;
  std::optional<double> deviation_m;  ///< mean distance of the readings from it, where measured
};

enum class FurnitureKind {
  against_wall,   ///< cupboards, desks along walls
  free_standing,  ///< tables, chairs, columns of boxes
};

[[nodiscard]] const char* to_string(FurnitureKind kind);

/// An obstacle that is no wall.
struct PlanFurniture {
  Polygon outline;
  FurnitureKind kind = FurnitureKind::free_standing;
};

[[nodiscard]] std::vector<Polygon> outlines_of(const std::vector<PlanFurniture>& furniture);

/// The merged master map (paper III: "a human readable master map"). Also the description of a
/// world for the simulator: one type, so that an assembled plan can be driven through again.
struct FloorPlan {
  std::string title;
  std::vector<PlanRoom> rooms;
  std::vector<PlanDoor> doors;
  std::vector<Polygon> walls;       ///< wall bodies with thickness; doors are gaps in them
  std::vector<Polygon> free_space;  ///< union of the rooms and door openings, with holes
  std::vector<PlanFurniture> furniture;
  std::vector<PlanEdge> edges;  ///< of the rooms, in their order; empty in a world
  Issues issues;
};

/// The room of that number, null where the plan has none.
[[nodiscard]] const PlanRoom* find_room(const FloorPlan& plan, RoomId id);
[[nodiscard]] bool has_room(const FloorPlan& plan, RoomId id);

[[nodiscard]] std::size_t count_of(const FloorPlan& plan, DoorKind kind);
/// "3 doors, 1 passage, 2 windows": of passages and windows only where there are any.
[[nodiscard]] std::string openings_text(const FloorPlan& plan);

}  // namespace roomatlas
