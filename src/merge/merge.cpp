// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/merge/merge.hpp"

#include "door_opening.hpp"
#include "floors.hpp"
#include "labels.hpp"
#include "room_kind.hpp"
#include "roomatlas/plan/room_ids.hpp"
#include "roomatlas/planar/simplify.hpp"
#include "wall_outline.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace roomatlas {
namespace {

using planar::Label;
using planar::MillimetreGrid;
using planar::Outlines;
using planar::PlanarMap;

constexpr double kMillimetres = 1000.0;     // in a metre
constexpr double kSquareMillimetres = 1e6;  // in a square metre
constexpr double kMinDoorWidth_m = 0.01;    // narrower has no direction that can be told
constexpr double kWallCrumb_mm2 = 1e4;      // 10 cm x 10 cm
// Of the thickness: what the outside of a wall smooths. Less shows each step of an outline there.
constexpr double kWallRoughness = 1.0 / 3.0;
constexpr double kShapeTolerance_m = 0.1;  // for judging a room's shape

MillimetreGrid grid_around(const std::vector<PlacedOutline>& outlines,
                           const std::vector<Door>& doors) {
  Box2 box;
  for (const PlacedOutline& outline : outlines) planar::extend(box, outline.outline);
  for (const Door& door : doors) {
    planar::extend(box, {{door.jambs.a, door.jambs.b}, {}});
  }
  return MillimetreGrid(box);
}

/// Usable doors in an order that does not depend on that of the input.
std::vector<Door> sorted_doors(const std::vector<Door>& doors, Issues& issues) {
  std::vector<Door> sorted;
  for (const Door& door : doors) {
    const bool is_plausible =
        planar::is_plausible(door.jambs.a) && planar::is_plausible(door.jambs.b);
    if (!is_plausible || (door.jambs.b - door.jambs.a).norm() < kMinDoorWidth_m) {
      issues.push_back(
          {Severity::warning, "", 0, "door", "its jambs are not finite or in one place: left out"});
    } else {
      sorted.push_back(door);
    }
  }
  const auto key = [](const Door& door) {
    const Segment2& jambs = door.jambs;
    return std::tuple(jambs.a.x() + jambs.b.x(), jambs.a.y() + jambs.b.y(), jambs.a.x(),
                      jambs.a.y(), door.room_a, door.room_b);
  };
  std::sort(sorted.begin(), sorted.end(),
            [&](const Door& a, const Door& b) { return key(a) < key(b); });
  return sorted;
}

/// The rooms on both sides, the smaller id first.
/// @param first, second positions of rooms, -1 where there is none.
void set_rooms(PlanDoor& door, const Outlines& outlines, int first, int second) {
  const auto id_of = [&](int room) { return outlines.rooms[static_cast<std::size_t>(room)].id; };
  if (first < 0 || (second >= 0 && second < first)) std::swap(first, second);
  if (first >= 0) door.room_a = id_of(first);
  if (second >= 0 && second != first) door.room_b = id_of(second);
}

/// The position of each room with an outline.
std::map<RoomId, int> positions_of(const Outlines& outlines) {
  std::map<RoomId, int> position_of;
  for (const int room : outlines.room_of_shape) {
    position_of.emplace_hint(position_of.end(), outlines.rooms[static_cast<std::size_t>(room)].id,
                             room);
  }
  return position_of;
}

std::vector<PlanDoor> doors_of(const std::vector<Door>& doors, const MillimetreGrid& grid,
                               const Outlines& outlines, double wall_thickness_mm,
                               std::vector<Polygon>& openings_mm) {
  const planar::ShapeIndex index(outlines.shapes_mm);
  const planar::FloorLookup lookup(outlines, index);
  const std::map<RoomId, int> position_of = positions_of(outlines);
  const auto index_of = [&](const std::optional<RoomId>& id) {  // -1: no floor, or not known
    const auto at = id ? position_of.find(*id) : position_of.end();
    return at == position_of.end() ? -1 : at->second;
  };
  std::vector<PlanDoor> placed;
  for (const Door& door : doors) {
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
    result.kind = door.kind;
    result.leaf = door.leaf;
    set_rooms(result, outlines, first, second);
    openings_mm.push_back({opening_mm, {}});
    placed.push_back(std::move(result));
  }
  return placed;
}

/// Doors are of no room that is not in the plan.
void forget_missing_rooms(FloorPlan& plan) {
  const std::set<RoomId> rooms = room_ids(plan);
  const auto forget = [&](std::optional<RoomId>& side) {
    if (side && !rooms.contains(*side)) side.reset();
  };
  for (PlanDoor& door : plan.doors) {
    forget(door.room_a);
    forget(door.room_b);
    if (!door.room_a) std::swap(door.room_a, door.room_b);
  }
}

/// Shapes whose planar map is the plan: door openings, outlines, and the outlines with walls
/// around.
struct PlanShapes {
  std::vector<Polygon> shapes_mm;
  int first_outline = 0;
  int first_wall = 0;
};

PlanShapes plan_shapes(const Outlines& outlines, const std::vector<Polygon>& openings_mm,
                       double wall_thickness_mm) {
  PlanShapes all{openings_mm, static_cast<int>(openings_mm.size()), 0};
  all.shapes_mm.insert(all.shapes_mm.end(), outlines.shapes_mm.begin(), outlines.shapes_mm.end());
  all.first_wall = static_cast<int>(all.shapes_mm.size());
  if (!(wall_thickness_mm > 0.0)) return all;
  for (const Polygon& shape : outlines.shapes_mm) {
    const Polygon smooth = planar::simplified(shape, kWallRoughness * wall_thickness_mm);
    all.shapes_mm.push_back(planar::rounded(planar::wall_outline(smooth, wall_thickness_mm)));
  }
  return all;
}

/// Every point a door opening, a room, wall or unknown: floors first, then doors cut into them,
/// then walls where there is neither.
std::vector<Label> labels_of(const PlanarMap& map, const PlanShapes& shapes,
                             const Outlines& outlines, const MergeOptions& options,
                             Issues& issues) {
  const planar::RegionMap regions(map);
  const double min_part_mm2 = options.min_part_area_m2 * kSquareMillimetres;
  std::vector<Label> labels =
      planar::floor_labels(regions, shapes.first_outline, outlines, min_part_mm2, issues);
  for (int region = 0; region < map.region_count(); ++region) {
    Label& label = labels[static_cast<std::size_t>(region)];
    const std::span<const int> over = map.covering(region);
    if (over.empty()) continue;
    if (over.front() < shapes.first_outline) {
      label = planar::kDoor;
    } else if (label == planar::kUnknown && over.back() >= shapes.first_wall) {
      label = planar::kWall;
    }
  }
  (void)planar::absorb_small_rooms(regions, min_part_mm2, labels);
  planar::clear_wall_crumbs(regions, kWallCrumb_mm2, labels);
  planar::fill_wall_cavities(regions, options.wall_thickness_m * kMillimetres, labels);
  return labels;
}

std::vector<std::vector<Polygon>> traced(const PlanarMap& map, const std::vector<int>& group,
                                         int groups, const MillimetreGrid& grid) {
  auto polygons = map.trace(group, groups);
  for (auto& of_group : polygons) of_group = grid.to_metres(of_group);
  return polygons;
}

/// Well inside the part: its clearance is the greatest but for a third of the usual one.
Point2 label_point(const Polygon& part, const Polygon& smooth_part, double area_m2) {
  constexpr double kOfWidth = 0.3;    // of area over perimeter, half of a strip's width: finer ...
  constexpr double kFinest_m = 0.05;  // ... costs time, and nobody sees a label that much off
  double perimeter_m = 0.0;
  for (std::size_t i = 0; i < part.outer.size(); ++i) {
    perimeter_m += (part.outer[(i + 1) % part.outer.size()] - part.outer[i]).norm();
  }
  const Point2 point =
      interior_point(smooth_part, std::max(kFinest_m, kOfWidth * area_m2 / perimeter_m));
  return contains(part, point) ? point : interior_point(part);
}

PlanRoom room_of(const planar::RoomEntry& entry, std::vector<Polygon> parts) {
  PlanRoom room;
  room.id = entry.id;
  room.name = std::to_string(entry.id);
  room.asrs = entry.asrs;
  room.parts = std::move(parts);
  for (const Polygon& part : room.parts) room.area_m2 += area(part);
  const Polygon& part = room.parts.front();
  const Polygon smooth_part = planar::simplified(part, kShapeTolerance_m);
  room.label_point = label_point(part, smooth_part, area(part));
  room.kind = kind_of(smooth_part, room.area_m2);
  return room;
}

}  // namespace

FloorPlan merge(const std::vector<PlacedOutline>& placed_outlines, const std::vector<Door>& doors,
                const MergeOptions& options, const std::vector<Polygon>& wall_bodies) {
  FloorPlan plan;
  const MillimetreGrid grid = grid_around(placed_outlines, doors);
  const Outlines outlines = planar::outlines_of(placed_outlines, grid, plan.issues);
  const double thickness_mm = options.wall_thickness_m * kMillimetres;
  std::vector<Polygon> openings_mm;
  plan.doors =
      doors_of(sorted_doors(doors, plan.issues), grid, outlines, thickness_mm, openings_mm);
  PlanShapes shapes = plan_shapes(outlines, openings_mm, thickness_mm);
  for (const Polygon& body : wall_bodies) shapes.shapes_mm.push_back(planar::on_grid(grid, body));
  const PlanarMap map(shapes.shapes_mm, grid.fine(), shapes.first_wall);
  const std::vector<Label> labels = labels_of(map, shapes, outlines, options, plan.issues);

  const int room_count = static_cast<int>(outlines.rooms.size());
  std::vector<int> body;  // of each region: its room, or one more for walls
  std::vector<int> free;
  for (const Label label : labels) {
    body.push_back(label == planar::kWall ? room_count : std::max(label, -1));
    free.push_back(label >= 0 || label == planar::kDoor ? 0 : -1);
  }
  auto bodies = traced(map, body, room_count + 1, grid);
  plan.walls = std::move(bodies.back());
  plan.free_space = std::move(traced(map, free, 1, grid).front());
  for (std::size_t r = 0; r < outlines.rooms.size(); ++r) {
    if (bodies[r].empty()) {
      plan.issues.push_back({Severity::warning, "", 0,
                             "room " + std::to_string(outlines.rooms[r].id),
                             "has no place of its own: not in the plan"});
    } else {
      plan.rooms.push_back(room_of(outlines.rooms[r], std::move(bodies[r])));
    }
  }
  forget_missing_rooms(plan);
  return plan;
}

}  // namespace roomatlas
