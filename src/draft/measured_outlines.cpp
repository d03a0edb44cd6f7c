// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "roomatlas/asr/trace_outline.hpp"
#include "roomatlas/draft/draft_building.hpp"

namespace roomatlas {
namespace {

constexpr double kRegrow_m = 0.3;  // gives back what margins took

/// The box of each room's cells.
std::map<RoomId, CellBox> boxes_of(const Raster<std::int32_t>& rooms) {
  std::map<RoomId, CellBox> boxes;
  for_each_cell(rooms.domain, [&](const Cell& cell) {
    const RoomId room = rooms[cell];
    if (room == 0) return;
    CellBox& box = boxes.try_emplace(room, CellBox{cell, cell}).first->second;
    box.min = {std::min(box.min.x, cell.x), std::min(box.min.y, cell.y)};
    box.max = {std::max(box.max.x, cell.x + 1), std::max(box.max.y, cell.y + 1)};
  });
  return boxes;
}

/// The free cells of one room, grown to the walls around it.
/// @param box of the room's cells
CellMask region_of(RoomId room, const CellBox& box, const DraftedBuilding& drafted) {
  const Raster<std::int32_t>& rooms = drafted.partition.room_of_cell;
  const CellMask& free = drafted.occupancy.free;
  const int grow = static_cast<int>(std::lround(kRegrow_m / drafted.occupancy.frame.cell_m));
  CellMask region(rooms.domain.within({{box.min.x - grow - 1, box.min.y - grow - 1},
                                       {box.max.x + grow + 1, box.max.y + grow + 1}}));
  CellMask may_grow(region.domain);
  for_each_cell(region.domain, [&](const Cell& cell) {
    const RoomId here = rooms.get(cell);
    region.set(cell, here == room && free.at(cell));
    may_grow.set(cell, free.at(cell) && (here == room || here == 0));
  });
  for (int step = 0; step < grow; ++step) region = both(dilated(region, 1), may_grow);
  return region;
}

}  // namespace

std::vector<PlacedOutline> measured_outlines(const DraftedBuilding& drafted,
                                             const BuildingEvidence& evidence,
                                             const RoomMapOptions& map) {
  const CellFrame& frame = drafted.occupancy.frame;
  const auto is_wall = [&](const Cell& cell) { return drafted.occupancy.obstacle.at(cell); };
  const WallNear wall_near = [&](const Cell& outside) -> std::optional<Point2> {
    const std::optional<Cell> wall = nearest_wall_cell(outside, is_wall);
    return wall ? std::optional<Point2>(evidence.counts.mean_hit(*wall)) : std::nullopt;
  };
  RoomMapOptions outline = map;
  if (evidence.kind == SensorKind::sonar) {
    outline.simplify_tolerance_m = outline.sonar_simplify_tolerance_m;
  }
  const auto hole_cells =
      static_cast<std::int64_t>(outline.min_hole_m2 / (frame.cell_m * frame.cell_m));
  const std::map<RoomId, CellBox> boxes = boxes_of(drafted.partition.room_of_cell);
  std::vector<PlacedOutline> outlines;
  for (const DraftedRoom& room : drafted.rooms) {
    std::vector<Point2> jambs;
    for (const Door& door : drafted.doors) {
      if (door.room_a != room.id && door.room_b != room.id) continue;
      jambs.insert(jambs.end(), {door.jambs.a, door.jambs.b});
    }
    const auto box = boxes.find(room.id);
    const CellMask filled = box != boxes.end()
                                ? holes_filled(region_of(room.id, box->second, drafted), hole_cells)
                                : CellMask(CellBox{});
    outlines.push_back({0, room.id, trace_outline(filled, frame, wall_near, jambs, outline)});
  }
  return outlines;
}

}  // namespace roomatlas
