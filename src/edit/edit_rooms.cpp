// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "editable.hpp"
#include "roomatlas/planar/union.hpp"

namespace roomatlas::edit {
namespace {

constexpr double kReach_m = 0.3;       // of a cut beyond its ends: a pointer stops short of walls
constexpr double kHalfSlit_m = 0.001;  // of what shows how many parts a cut leaves
constexpr double kSmallestPart_m2 = 0.5;
constexpr double kFar_m = 1e4;  // farther than any building reaches

bool joins(const Door& door, RoomId first, RoomId second) {
  return (door.room_a == first && door.room_b == second) ||
         (door.room_a == second && door.room_b == first);
}

void take_over(RoomId from, RoomId to, MappedBuilding& building) {
  for (auto& [asr, room] : building.room_of_asr) {
    if (room == from) room = to;
  }
  for (PlacedOutline& outline : building.measured_outlines) {
    if (outline.room == from) outline.room = to;
  }
  for (Door& door : building.doors) {
    if (door.room_a == from) door.room_a = to;
    if (door.room_b == from) door.room_b = to;
  }
  if (const auto name = building.names.find(from); name != building.names.end()) {
    building.names.emplace(to, name->second);
    building.names.erase(from);
  }
  building.kinds.erase(from);
}

/// The larger of a room's parts by a cut, and the rest; empty where it does not leave two.
std::array<Shapes, 2> parts_by(const Edit& edit, const Shapes& room, Why& why) {
  const double half_m = std::max(kHalfSlit_m, edit.thickness_m / 2.0);
  Shapes whole = difference_of(room, {band(edit.line, half_m, half_m, kReach_m)});
  std::erase_if(whole, [](const Polygon& part) { return area(part) < kSmallestPart_m2; });
  if (whole.size() != 2) {
    why = "the line leaves " + std::to_string(whole.size()) +
          " parts of the room: it must go from wall to wall and leave two";
    return {};
  }
  if (edit.thickness_m > 0.0) return {Shapes{whole[0]}, Shapes{whole[1]}};
  std::array<Shapes, 2> parts;
  for (const bool is_left : {false, true}) {
    const Polygon side = band(edit.line, is_left ? kFar_m : 0.0, is_left ? 0.0 : kFar_m, kFar_m);
    for (const Polygon& piece : difference_of(room, {side})) {
      const bool is_second = overlap_area({piece}, {whole[1]}) > overlap_area({piece}, {whole[0]});
      parts[is_second ? 1 : 0].push_back(piece);
    }
  }
  return {union_of(parts[0]), union_of(parts[1])};
}

/// The line from wall to wall.
Segment2 across(const Edit& edit, const Shapes& room) {
  const Point2 along = (edit.line.b - edit.line.a).normalized();
  Segment2 clipped = edit.line;
  const auto shorten = [&](Point2 from, Point2& end, double reach_m) {
    const Point2 target = end + reach_m * (end - from).normalized();
    double nearest = 1.0;
    for (const Polygon& shape : room) {
      for (std::size_t i = 0; i < shape.outer.size(); ++i) {
        const Segment2 side{shape.outer[i], shape.outer[(i + 1) % shape.outer.size()]};
        if (const auto at = crossing_fraction({from, target}, side))
          nearest = std::min(nearest, *at);
      }
    }
    end = from + nearest * (target - from);
  };
  Point2 middle = (edit.line.a + edit.line.b) / 2.0;
  if (!covers(room, middle))
    middle = edit.line.a + 0.25 * (edit.line.b - edit.line.a).norm() * along;
  shorten(middle, clipped.a, kReach_m);
  shorten(middle, clipped.b, kReach_m);
  return clipped;
}

/// What belonged to the whole room and lies in its second part.
void give_to_second(const Shapes& first, const Shapes& second, RoomId room, RoomId added,
                    MappedBuilding& building) {
  std::vector<PlacedOutline> measured;
  for (const PlacedOutline& outline : building.measured_outlines) {
    if (outline.room != room) {
      measured.push_back(outline);
      continue;
    }
    for (const Polygon& piece : difference_of({outline.outline}, second)) {
      measured.push_back({outline.asr, room, piece});
    }
    for (const Polygon& piece : difference_of({outline.outline}, first)) {
      measured.push_back({outline.asr, added, piece});
    }
  }
  building.measured_outlines = std::move(measured);
  const auto distance_m = [](const Shapes& shapes, const Point2& point) {
    double least = kFar_m;
    for (const Polygon& shape : shapes) {
      least = std::min(least, distance_to_boundary(shape.outer, point));
      for (const Ring& hole : shape.holes)
        least = std::min(least, distance_to_boundary(hole, point));
    }
    return least;
  };
  for (Door& door : building.doors) {
    const Point2 at = door.frame_from_pivot.position();
    const bool is_second = distance_m(second, at) < distance_m(first, at);
    if (is_second && door.room_a == room) door.room_a = added;
    if (is_second && door.room_b == room) door.room_b = added;
  }
}

}  // namespace

Why join_rooms(const Edit& edit, MappedBuilding& building) {
  const FoundRoom one = find_room(building, edit.rooms.at(0));
  if (!one.why.empty()) return one.why;
  const FoundRoom other = find_room(building, edit.rooms.at(1));
  if (!other.why.empty()) return other.why;
  if (one.room == other.room) return "both places lie in one room already";
  Shapes first = shapes_of(building.outlines, one.room);
  Shapes second = shapes_of(building.outlines, other.room);
  const bool is_first_larger = area_of(first) >= area_of(second);
  const RoomId kept = is_first_larger ? one.room : other.room;
  const RoomId gone = is_first_larger ? other.room : one.room;
  Shapes all = first;
  all.insert(all.end(), second.begin(), second.end());
  for (const Door& door : building.doors) {
    if (!joins(door, kept, gone)) continue;
    const Polygon through = band(door.jambs, kThickestWall_m / 2.0, kThickestWall_m / 2.0, 0.0);
    all.push_back(through);
  }
  Shapes others;  // the opening ends where another room begins
  for (const PlacedOutline& outline : building.outlines) {
    if (outline.room != kept && outline.room != gone) others.push_back(outline.outline);
  }
  const Shapes joined = difference_of(union_of(all), others);
  if (joined.size() >= first.size() + second.size()) {
    return "nothing is open between the rooms: add a door between them first";
  }
  std::erase_if(building.doors, [&](const Door& door) { return joins(door, kept, gone); });
  set_shapes(building, kept, joined);
  std::erase_if(building.outlines,
                [&](const PlacedOutline& outline) { return outline.room == gone; });
  std::erase_if(building.edges, [&](const PlanEdge& edge) { return edge.room == gone; });
  take_over(gone, kept, building);
  return {};
}

Why split_room(const Edit& edit, MappedBuilding& building) {
  const FoundRoom found = find_room(building, edit.rooms.at(0));
  if (!found.why.empty()) return found.why;
  const Shapes room = shapes_of(building.outlines, found.room);
  Why why;
  const auto [larger, smaller] = parts_by(edit, room, why);
  if (!why.empty()) return why;
  RoomId added = 0;
  for (const PlacedOutline& outline : building.outlines) added = std::max(added, outline.room);
  ++added;
  const std::vector<PlanEdge> edges = building.edges;
  set_shapes(building, found.room, larger);
  const auto own = std::find_if(building.outlines.begin(), building.outlines.end(),
                                [&](const auto& outline) { return outline.room == found.room; });
  const AsrId asr = own->asr;
  for (const Polygon& shape : smaller) building.outlines.push_back({asr, added, shape});
  if (!edges.empty()) {
    for (const PlanEdge& edge : refitted(added, smaller, edges)) building.edges.push_back(edge);
  }
  give_to_second(larger, smaller, found.room, added, building);
  const Segment2 cut = across(edit, room);
  if (edit.thickness_m > 0.0) {
    building.wall_bodies.push_back(band(cut, edit.thickness_m / 2.0, edit.thickness_m / 2.0, 0.0));
  } else {
    const bool is_left_larger = covers(larger, (cut.a + cut.b) / 2.0 + 0.05 * left_of(cut));
    Door open = door_between(cut, found.room, added);
    if (is_left_larger != covers(larger, open.frame_from_pivot * Point2(-0.05, 0.0))) {
      std::swap(open.room_a, open.room_b);
    }
    open.kind = DoorKind::passage;
    building.doors.push_back(open);
  }
  return {};
}

}  // namespace roomatlas::edit
