// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/changes/assembled_mission.hpp"

namespace roomatlas {
namespace {

void move(std::vector<Polygon>& polygons, const Pose2& to_from_here) {
  for (Polygon& polygon : polygons) polygon = transformed(to_from_here, polygon);
}

}  // namespace

FloorPlan moved(FloorPlan plan, const Pose2& to_from_here) {
  for (PlanRoom& room : plan.rooms) {
    move(room.parts, to_from_here);
    room.label_point = to_from_here * room.label_point;
  }
  for (PlanDoor& door : plan.doors) {
    door.jambs = transformed(to_from_here, door.jambs);
    door.opening = transformed(to_from_here, door.opening);
    if (door.leaf) door.leaf = transformed(to_from_here, *door.leaf);
  }
  move(plan.walls, to_from_here);
  move(plan.free_space, to_from_here);
  for (PlanFurniture& piece : plan.furniture) {
    piece.outline = transformed(to_from_here, piece.outline);
  }
  for (PlanEdge& edge : plan.edges) edge.line = transformed(to_from_here, edge.line);
  return plan;
}

}  // namespace roomatlas
