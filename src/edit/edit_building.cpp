// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/edit/edit_building.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "editable.hpp"
#include "roomatlas/planar/union.hpp"

namespace roomatlas {
namespace edit {
namespace {

constexpr double kLeastShare = 0.4;  // of the larger of what a room was and is; less is another
                                     // room, or several where there was one

std::string words(const RoomAnchor& anchor) {
  return anchor.id ? "room " + std::to_string(*anchor.id) : std::string("the room");
}

std::set<RoomId> rooms_of(const MappedBuilding& building) {
  std::set<RoomId> rooms;
  for (const PlacedOutline& outline : building.outlines) rooms.insert(outline.room);
  return rooms;
}

Why name_room(const Edit& edit, MappedBuilding& building) {
  const FoundRoom found = find_room(building, edit.rooms.at(0));
  if (!found.why.empty()) return found.why;
  for (const RoomId room : rooms_of(building)) {
    if (room != found.room && std::to_string(room) == edit.name) {
      return "\"" + edit.name + "\" is the number of another room";
    }
  }
  std::erase_if(building.names, [&](const auto& entry) { return entry.second == edit.name; });
  building.names[found.room] = edit.name;
  return {};
}

/// The room that lost its name to another by a statement.
std::optional<RoomId> gives_name_up(const std::map<RoomId, std::string>& before, const Edit& edit,
                                    const MappedBuilding& now) {
  if (edit.kind != EditKind::name_room) return std::nullopt;
  for (const auto& [room, name] : before) {
    if (name == edit.name && !now.names.contains(room)) return room;
  }
  return std::nullopt;
}

Why set_room_kind(const Edit& edit, MappedBuilding& building) {
  const FoundRoom found = find_room(building, edit.rooms.at(0));
  if (found.why.empty()) building.kinds[found.room] = edit.room_kind;
  return found.why;
}

Why apply(const Edit& edit, MappedBuilding& building) {
  switch (edit.kind) {
    case EditKind::name_room:
      return name_room(edit, building);
    case EditKind::set_room_kind:
      return set_room_kind(edit, building);
    case EditKind::join_rooms:
      return join_rooms(edit, building);
    case EditKind::split_room:
      return split_room(edit, building);
    case EditKind::shut_door:
      return shut_door(edit, building);
    case EditKind::open_door:
      return open_door(edit, building);
    case EditKind::add_door:
      return add_door(edit, building);
    case EditKind::move_wall:
      return move_wall(edit, building);
    case EditKind::furniture_to_wall:
      return furniture_to_wall(edit, building);
    case EditKind::wall_to_furniture:
      return wall_to_furniture(edit, building);
    case EditKind::reject_closure:
    case EditKind::pin_visits:
      return {};
  }
  return {};
}

/// A door that was shut and is opened again: neither is applied.
std::set<std::size_t> taken_back(const std::vector<Edit>& edits) {
  std::set<std::size_t> taken;
  for (std::size_t i = 0; i < edits.size(); ++i) {
    if (edits[i].kind != EditKind::open_door) continue;
    for (std::size_t k = i; k-- > 0;) {
      if (edits[k].kind != EditKind::shut_door || taken.contains(k)) continue;
      if ((edits[k].at - edits[i].at).norm() > kEditReach_m) continue;
      taken.insert({k, i});
      break;
    }
  }
  return taken;
}

}  // namespace

FoundRoom find_room(const MappedBuilding& building, const RoomAnchor& anchor) {
  if (!anchor.at) return {0, words(anchor) + " is not known: say where it is with at_m"};
  FoundRoom found;
  Shapes shapes;
  for (const RoomId room : rooms_of(building)) {
    Shapes its = shapes_of(building.outlines, room);
    if (!covers(its, *anchor.at)) continue;
    if (found.room != 0) return {0, "several rooms lie where " + words(anchor) + " was"};
    found.room = room;
    shapes = std::move(its);
  }
  if (found.room == 0) return {0, "no room lies any more where " + words(anchor) + " was"};
  if (anchor.outline.empty()) return found;
  const Shapes was = union_of({{anchor.outline, {}}});
  const double shared_m2 = overlap_area(was, shapes);
  if (shared_m2 >= kLeastShare * std::max(area_of(was), area_of(shapes))) return found;
  return {0, "the room that lies where " + words(anchor) +
                 " was has another shape now: " + std::to_string(std::lround(shared_m2)) +
                 " m2 of " + std::to_string(std::lround(area_of(was))) +
                 " are the same, and it has " + std::to_string(std::lround(area_of(shapes)))};
}

}  // namespace edit

Issues edit_building(const std::vector<Edit>& edits, MappedBuilding& building) {
  const std::set<std::size_t> taken_back = edit::taken_back(edits);
  Issues issues;
  for (std::size_t i = 0; i < edits.size(); ++i) {
    if (taken_back.contains(i)) continue;
    const std::map<RoomId, std::string> before = building.names;
    const edit::Why why = edit::apply(edits[i], building);
    if (!why.empty()) {
      issues.push_back(edit_issue(i, edits[i], "no longer fits and is not applied: " + why));
    } else if (const auto gave = edit::gives_name_up(before, edits[i], building)) {
      issues.push_back(edit_issue(
          i, edits[i], "the name was room " + std::to_string(*gave) + "'s, which has none now"));
    }
  }
  return issues;
}

}  // namespace roomatlas
