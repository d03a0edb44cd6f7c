// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/merge/merge.hpp"

#include "door_opening.hpp"
#include "floors.hpp"
#include "labels.hpp"
#include "room_kind.hpp"
#include "wall_bands.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace roomatlas {
namespace {

using planar::Label;
using planar::MillimetreGrid;
using planar::PlanarMap;
using planar::RoomOutlines;

constexpr double kMillimetres = 1000.0;
constexpr double kSquareMillimetres = 1e6;
constexpr double kMinDoorWidth_m = 0.01;
constexpr double kWallCrumb_mm2 = 1e4;  // 10 cm x 10 cm

using Floors = std::vector<std::vector<Polygon>>;  // the parts of each room, millimetres

MillimetreGrid grid_around(const std::vector<PlacedOutline>& outlines,
                           const std::vector<PlacedDoor>& doors) {
  Box2 box;
  for (const PlacedOutline& outline : outlines) planar::extend(box, outline.outline);
  for (const PlacedDoor& door : doors) {
    planar::extend(box, {{door.jambs.a, door.jambs.b}, {}});
  }
  return MillimetreGrid(box);
}

/// The position of each room with a floor.
std::map<RoomId, int> positions_of(const std::vector<RoomOutlines>& rooms,
                                   const Floors& floors_mm) {
  std::map<RoomId, int> position_of;
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    if (!floors_mm[r].empty()) position_of.emplace(rooms[r].id, static_cast<int>(r));
  }
  return position_of;
}

/// Usable doors in an order that does not depend on that of the input.
std::vector<PlacedDoor> sorted_doors(const std::vector<PlacedDoor>& doors, Issues& issues) {
  std::vector<PlacedDoor> sorted;
  for (const PlacedDoor& door : doors) {
    const bool is_plausible =
        planar::is_plausible(door.jambs.a) && planar::is_plausible(door.jambs.b);
    if (!is_plausible || (door.jambs.b - door.jambs.a).norm() < kMinDoorWidth_m) {
      issues.push_back(
          {Severity::warning, "", 0, "door", "its jambs are not finite or in one place: left out"});
    } else {
      sorted.push_back(door);
    }
  }
  const auto key = [](const PlacedDoor& door) {
    const Segment2& jambs = door.jambs;
    return std::tuple(jambs.a.x() + jambs.b.x(), jambs.a.y() + jambs.b.y(), jambs.a.x(),
                      jambs.a.y(), door.room_a, door.room_b);
  };
  std::sort(sorted.begin(), sorted.end(),
            [&](const PlacedDoor& a, const PlacedDoor& b) { return key(a) < key(b); });
  return sorted;
}

/// The rooms on both sides: those with a floor, the smaller id first.
void set_rooms(PlanDoor& door, const std::vector<RoomOutlines>& rooms, int first, int second) {
  if (first < 0 || (second >= 0 && second < first)) std::swap(first, second);
  if (first >= 0) door.room_a = rooms[static_cast<std::size_t>(first)].id;
  if (second >= 0 && second != first) door.room_b = rooms[static_cast<std::size_t>(second)].id;
}

std::vector<PlanDoor> doors_of(const std::vector<PlacedDoor>& doors, const MillimetreGrid& grid,
                               const std::vector<RoomOutlines>& rooms, const Floors& floors_mm,
                               double wall_thickness_mm, std::vector<Polygon>& openings_mm) {
  std::vector<Polygon> parts_mm;
  std::vector<int> room_of_part;
  for (std::size_t r = 0; r < floors_mm.size(); ++r) {
    parts_mm.insert(parts_mm.end(), floors_mm[r].begin(), floors_mm[r].end());
    room_of_part.resize(parts_mm.size(), static_cast<int>(r));
  }
  const planar::ShapeIndex index(parts_mm);
  const planar::FloorLookup lookup{room_of_part, index};
  const std::map<RoomId, int> position_of = positions_of(rooms, floors_mm);
  const auto index_of = [&](const std::optional<RoomId>& id) {  // -1: no floor, or not known
    const auto at = id ? position_of.find(*id) : position_of.end();
    return at == position_of.end() ? -1 : at->second;
  };
  std::vector<PlanDoor> placed;
  for (const PlacedDoor& door : doors) {
    const int first = index_of(door.room_a);
    const int second = index_of(door.room_b);
    const Segment2 jambs_mm{grid.to_grid(door.jambs.a), grid.to_grid(door.jambs.b)};
    const Ring opening_mm =
        planar::door_opening(jambs_mm, lookup, first, second, wall_thickness_mm);
    PlanDoor result;
    result.id = static_cast<std::int64_t>(placed.size()) + 1;
    result.jambs = {grid.to_metres(jambs_mm.a), grid.to_metres(jambs_mm.b)};
    result.width_m = (result.jambs.b - result.jambs.a).norm();
    result.opening = grid.to_metres(opening_mm);
    set_rooms(result, rooms, first, second);
    openings_mm.push_back({opening_mm, {}});
    placed.push_back(std::move(result));
  }
  return placed;
}

/// The second planar map: every point a door opening, a room, wall or unknown.
struct LabelledPlan {
  PlanarMap map;
  std::vector<Label> labels;
};

LabelledPlan labelled(const Floors& floors_mm, const std::vector<Polygon>& openings_mm,
                      const MergeOptions& options) {
  std::vector<Polygon> shapes_mm;
  std::vector<Label> label_of_shape;
  const auto add = [&](const std::vector<Polygon>& shapes, Label label) {
    shapes_mm.insert(shapes_mm.end(), shapes.begin(), shapes.end());
    label_of_shape.resize(shapes_mm.size(), label);
  };
  const double thickness_mm = options.wall_thickness_m * kMillimetres;
  add(openings_mm, planar::kDoor);  // first come, first served below
  for (std::size_t r = 0; r < floors_mm.size(); ++r) add(floors_mm[r], static_cast<Label>(r));
  for (const auto& parts : floors_mm) {
    for (const Polygon& part : parts) add(planar::wall_bands(part, thickness_mm), planar::kWall);
  }
  LabelledPlan plan{PlanarMap(shapes_mm), {}};
  for (int region = 0; region < plan.map.region_count(); ++region) {
    const std::span<const int> over = plan.map.covering(region);
    plan.labels.push_back(over.empty() ? planar::kUnknown
                                       : label_of_shape[static_cast<std::size_t>(over.front())]);
  }
  (void)planar::absorb_small_rooms(plan.map, options.min_part_area_m2 * kSquareMillimetres,
                                   plan.labels);
  planar::clear_wall_crumbs(plan.map, kWallCrumb_mm2, plan.labels);
  planar::fill_wall_cavities(plan.map, thickness_mm, plan.labels);
  return plan;
}

std::vector<std::vector<Polygon>> traced(const LabelledPlan& plan, const std::vector<int>& group,
                                         int groups, const MillimetreGrid& grid) {
  auto polygons = plan.map.trace(group, groups);
  for (auto& of_group : polygons) {
    for (Polygon& polygon : of_group) polygon = planar::without_straight_vertices(polygon);
    of_group = grid.to_metres(of_group);
  }
  return polygons;
}

PlanRoom room_of(const RoomOutlines& outlines, std::vector<Polygon> parts) {
  PlanRoom room;
  room.id = outlines.id;
  room.name = std::to_string(outlines.id);
  room.asrs = outlines.asrs;
  room.parts = std::move(parts);
  for (const Polygon& part : room.parts) room.area_m2 += area(part);
  room.label_point = interior_point(room.parts.front());
  room.kind = kind_of(room.parts.front(), room.area_m2);
  return room;
}

}  // namespace

FloorPlan merge(const std::vector<PlacedOutline>& outlines, const std::vector<PlacedDoor>& doors,
                const MergeOptions& options) {
  FloorPlan plan;
  const MillimetreGrid grid = grid_around(outlines, doors);
  const auto rooms = planar::room_outlines(outlines, grid, plan.issues);
  const Floors floors_mm =
      planar::floors_of(rooms, options.min_part_area_m2 * kSquareMillimetres, plan.issues);
  std::vector<Polygon> openings_mm;
  plan.doors = doors_of(sorted_doors(doors, plan.issues), grid, rooms, floors_mm,
                        options.wall_thickness_m * kMillimetres, openings_mm);
  const LabelledPlan final_map = labelled(floors_mm, openings_mm, options);

  const int room_count = static_cast<int>(rooms.size());
  std::vector<int> body;  // of each region: its room, or one more for walls
  std::vector<int> free;
  for (const Label label : final_map.labels) {
    body.push_back(label == planar::kWall ? room_count : std::max(label, -1));
    free.push_back(label >= 0 || label == planar::kDoor ? 0 : -1);
  }
  auto bodies = traced(final_map, body, room_count + 1, grid);
  plan.walls = std::move(bodies.back());
  plan.free_space = std::move(traced(final_map, free, 1, grid).front());
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    if (bodies[r].empty()) {
      plan.issues.push_back({Severity::warning, "", 0, "room " + std::to_string(rooms[r].id),
                             "has no place of its own: not in the plan"});
    } else {
      plan.rooms.push_back(room_of(rooms[r], std::move(bodies[r])));
    }
  }
  return plan;
}

}  // namespace roomatlas
