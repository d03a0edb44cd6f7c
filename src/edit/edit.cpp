// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/edit/edit.hpp"

#include <algorithm>

namespace roomatlas {

const char* to_string(EditKind kind) {
  switch (kind) {
    case EditKind::name_room:
      return "name_room";
    case EditKind::set_room_kind:
      return "set_room_kind";
    case EditKind::join_rooms:
      return "join_rooms";
    case EditKind::split_room:
      return "split_room";
    case EditKind::shut_door:
      return "shut_door";
    case EditKind::open_door:
      return "open_door";
    case EditKind::add_door:
      return "add_door";
    case EditKind::move_wall:
      return "move_wall";
    case EditKind::furniture_to_wall:
      return "furniture_to_wall";
    case EditKind::wall_to_furniture:
      return "wall_to_furniture";
    case EditKind::reject_closure:
      return "reject_closure";
    case EditKind::pin_visits:
      return "pin_visits";
  }
  return "unknown";
}

RoomAnchor anchor_of(const PlanRoom& room) {
  RoomAnchor anchor{room.id, room.label_point, {}};
  if (room.parts.empty()) return anchor;
  anchor.outline = room.parts.front().outer;
  if (!contains(room.parts.front(), room.label_point)) {
    anchor.at = interior_point(room.parts.front());
  }
  return anchor;
}

std::vector<Edit> with_places(std::vector<Edit> edits, const std::vector<PlanRoom>& rooms) {
  for (Edit& edit : edits) {
    for (RoomAnchor& anchor : edit.rooms) {
      if (anchor.at || !anchor.id) continue;
      const auto room = std::find_if(rooms.begin(), rooms.end(),
                                     [&](const PlanRoom& one) { return one.id == *anchor.id; });
      if (room != rooms.end()) anchor = anchor_of(*room);
    }
  }
  return edits;
}

Issue edit_issue(std::size_t index, const Edit& edit, const std::string& why, Severity severity) {
  return {severity, "", 0, "edits[" + std::to_string(index) + "] " + to_string(edit.kind), why};
}

}  // namespace roomatlas
