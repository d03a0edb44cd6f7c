// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/plan/floor_plan.hpp"

#include <algorithm>

#include "roomatlas/core/counted.hpp"

namespace roomatlas {

const char* to_string(RoomKind kind) {
  switch (kind) {
    case RoomKind::corridor:
      return "corridor";
    case RoomKind::hall:
      return "hall";
    case RoomKind::room:
      break;
  }
  return "room";
}

const char* to_string(DoorKind kind) {
  switch (kind) {
    case DoorKind::passage:
      return "passage";
    case DoorKind::window:
      return "window";
    case DoorKind::door:
      break;
  }
  return "door";
}

std::size_t count_of(const FloorPlan& plan, DoorKind kind) {
  return static_cast<std::size_t>(
      std::count_if(plan.doors.begin(), plan.doors.end(),
                    [&](const PlanDoor& door) { return door.kind == kind; }));
}

std::string openings_text(const FloorPlan& plan) {
  std::string text = counted(count_of(plan, DoorKind::door), "door");
  for (const DoorKind kind : {DoorKind::passage, DoorKind::window}) {
    const std::size_t count = count_of(plan, kind);
    if (count > 0) text += ", " + counted(count, to_string(kind));
  }
  return text;
}

const char* to_string(WallEvidence evidence) {
  switch (evidence) {
    case WallEvidence::inferred:
      return "inferred";
    case WallEvidence::unexplored:
      return "unexplored";
    case WallEvidence::measured:
      break;
  }
  return "measured";
}

const char* to_string(FurnitureKind kind) {
  switch (kind) {
    case FurnitureKind::against_wall:
      return "against_wall";
    case FurnitureKind::free_standing:
      break;
  }
  return "free_standing";
}

std::vector<Polygon> outlines_of(const std::vector<PlanFurniture>& furniture) {
  std::vector<Polygon> outlines;
  outlines.reserve(furniture.size());
  for (const PlanFurniture& piece : furniture) outlines.push_back(piece.outline);
  return outlines;
}

const PlanRoom* find_room(const FloorPlan& plan, RoomId id) {
  const auto found = std::find_if(plan.rooms.begin(), plan.rooms.end(),
                                  [&](const PlanRoom& room) { return room.id == id; });
  return found == plan.rooms.end() ? nullptr : &*found;
}

bool has_room(const FloorPlan& plan, RoomId id) { return find_room(plan, id) != nullptr; }

}  // namespace roomatlas
