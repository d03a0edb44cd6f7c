// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/rooms/map_building.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "roomatlas/asr/load.hpp"
#include "roomatlas/asr/trace_outline.hpp"
#include "roomatlas/polyline/simplify.hpp"

namespace roomatlas {
namespace {

constexpr double kRegrowM = 0.3;  // gives back what margins took

/// The mission as one map and one path.
struct PlacedReadings {
  ReflectionMap map;
  std::vector<Pose2> building_from_robot;
  std::vector<AsrId> asr_of_pose;
  SensorKind kind = SensorKind::laser;  ///< sonar where there were both
};

PlacedReadings placed_readings(const AsrSource& source, const Placement& placement,
                               const MapBuildingOptions& options, const Progress& progress) {
  PlacedReadings placed{ReflectionMap(options.segment.grid.cell_m), {}, {}, SensorKind::laser};
  const RayOptions rays = ray_options(options.map);
  std::int64_t ignored = 0;  // counted when each room was mapped
  std::optional<Pose2> last;
  const std::vector<AsrId> ids = source.ids();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    report(progress, "map building", share_of(i, ids.size()));
    const Asr asr = load_with_readings(source, ids[i]);
    for (std::size_t k = 0; k < asr.path.size(); ++k) {
      const Pose2 pose = placement.at(asr.id) * asr.path[k].asr_from_robot;
      placed.building_from_robot.push_back(pose);
      placed.asr_of_pose.push_back(asr.id);
      if (asr.readings[k].sensor->kind == SensorKind::sonar) placed.kind = SensorKind::sonar;
      if (last && !moved_enough(*last, pose, options.map)) continue;
      last = pose;
      placed.map.add_sweep(rays_of(asr.readings[k], pose, rays, ignored));
    }
  }
  return placed;
}

std::map<AsrId, RoomId> rooms_of_asrs(const PlacedReadings& placed,
                                      const std::vector<RoomId>& room_of_pose) {
  std::map<AsrId, std::map<RoomId, int>> votes;
  for (std::size_t i = 0; i < room_of_pose.size(); ++i) {
    ++votes[placed.asr_of_pose[i]][room_of_pose[i]];
  }
  std::map<AsrId, RoomId> room_of;
  for (const auto& [asr, rooms] : votes) {
    room_of[asr] = std::max_element(rooms.begin(), rooms.end(), [](const auto& a, const auto& b) {
                     return a.second < b.second;
                   })->first;
  }
  return room_of;
}

/// The doors in the order in which the robot first went through them, then those it only saw.
std::vector<Door> doors_of(const PlacedReadings& placed, const RoomSegmentation& rooms) {
  struct Found {
    Door door;
    std::size_t first_pose = 0;
  };
  std::vector<Found> found;
  for (const Door& opening : rooms.openings) {
    if (!opening.is_between_rooms()) continue;
    const Doorway exact = with_jambs_at_peaks(opening, placed.map);
    Found& next = found.emplace_back(Found{opening, placed.building_from_robot.size()});
    static_cast<Doorway&>(next.door) = doorway_at(exact.frame_from_pivot, exact.width_m);
  }
  for (std::size_t i = 1; i < rooms.room_of_pose.size(); ++i) {
    const RoomId from = rooms.room_of_pose[i - 1];
    const RoomId to = rooms.room_of_pose[i];
    if (from == to) continue;
    const Segment2 step{placed.building_from_robot[i - 1].position(),
                        placed.building_from_robot[i].position()};
    for (Found& one : found) {
      if (std::minmax(*one.door.room_a, *one.door.room_b) != std::minmax(from, to)) continue;
      if (!crossing_fraction(step, one.door.jambs)) continue;
      one.first_pose = std::min(one.first_pose, i);
      one.door.crossings.push_back(placed.asr_of_pose[i]);
      break;
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& a, const Found& b) { return a.first_pose < b.first_pose; });
  std::vector<Door> doors;
  for (Found& one : found) doors.push_back(std::move(one.door));
  return doors;
}

/// The cells of one room, grown to the walls around it.
CellMask region_of(RoomId room, const RoomSegmentation& rooms, const BuildingGrid& grid) {
  const int grow_cells = static_cast<int>(std::lround(kRegrowM / grid.frame.cell_m));
  CellBox box{rooms.box.max, rooms.box.min};
  for_each_cell(rooms.box, [&](const Cell& cell) {
    if (rooms.at(cell) != room) return;
    box.min = {std::min(box.min.x, cell.x), std::min(box.min.y, cell.y)};
    box.max = {std::max(box.max.x, cell.x + 1), std::max(box.max.y, cell.y + 1)};
  });
  box.min = {box.min.x - grow_cells - 1, box.min.y - grow_cells - 1};
  box.max = {box.max.x + grow_cells + 1, box.max.y + grow_cells + 1};
  CellMask region(box);
  CellMask may_grow(box);
  for_each_cell(box, [&](const Cell& cell) {
    const RoomId here = rooms.at(cell);
    region.set(cell, here == room);
    may_grow.set(cell, here == room || (here == 0 && grid.free.at(cell)));
  });
  for (int step = 0; step < grow_cells; ++step) region = both(dilated(region, 1), may_grow);
  return region;
}

/// The obstacles in what was filled: what stands free in a room.
void add_furniture(const CellMask& region, const CellMask& filled, const BuildingGrid& grid,
                   std::vector<Polygon>& furniture) {
  CellMask stands_free(region.box);
  for_each_cell(region.box, [&](const Cell& cell) {
    stands_free.set(cell, filled.at(cell) && !region.at(cell) && grid.obstacle.at(cell));
  });
  for (const CellBoundary& boundary : trace_boundaries(stands_free, grid.frame)) {
    if (signed_area(boundary.edge_midpoints) < 0.0) continue;  // a hole
    Ring ring = boundary.edge_midpoints;
    ring.push_back(ring.front());
    Polygon piece;
    for (const std::size_t kept : douglas_peucker(ring, grid.frame.cell_m, {})) {
      piece.outer.push_back(ring[kept]);
    }
    piece.outer.pop_back();
    if (piece.outer.size() >= 3) furniture.push_back(std::move(piece));
  }
}

/// The outline of each room that has one, and what stands free in it.
void add_outlines(const PlacedReadings& placed, const BuildingGrid& grid,
                  const RoomSegmentation& rooms, const MapBuildingOptions& options,
                  MappedBuilding& building) {
  const auto is_wall = [&](const Cell& cell) { return grid.obstacle.at(cell); };
  const WallNear wall_near = [&](const Cell& outside) -> std::optional<Point2> {
    const std::optional<Cell> wall = nearest_wall_cell(outside, is_wall);
    return wall ? std::optional<Point2>(placed.map.mean_hit(*wall)) : std::nullopt;
  };
  RoomMapOptions outline = options.map;
  if (placed.kind == SensorKind::sonar) {
    outline.simplify_tolerance_m = outline.sonar_simplify_tolerance_m;
  }
  const auto hole_cells =
      static_cast<std::int64_t>(outline.min_hole_m2 / (grid.frame.cell_m * grid.frame.cell_m));
  for (RoomId room = 1; room <= rooms.rooms; ++room) {
    std::vector<Point2> jambs;
    for (const Door& door : building.doors) {
      if (door.room_a != room && door.room_b != room) continue;
      jambs.insert(jambs.end(), {door.jambs.a, door.jambs.b});
    }
    const auto first = std::find_if(building.room_of_asr.begin(), building.room_of_asr.end(),
                                    [&](const auto& entry) { return entry.second == room; });
    const CellMask region = region_of(room, rooms, grid);
    const CellMask filled = holes_filled(region, hole_cells);
    building.outlines.push_back({first != building.room_of_asr.end() ? first->first : 0, room,
                                 trace_outline(filled, grid.frame, wall_near, jambs, outline)});
    add_furniture(region, filled, grid, building.furniture);
  }
}

}  // namespace

MappedBuilding map_building(const AsrSource& source, const Placement& placement,
                            const RobotFootprint& footprint, const MapBuildingOptions& options,
                            const Progress& progress) {
  const PlacedReadings placed = placed_readings(source, placement, options, progress);
  const BuildingGrid grid = building_grid(placed.map, placed.kind, placed.building_from_robot,
                                          footprint, options.segment.grid);
  const RoomSegmentation rooms = segment_rooms(grid, placed.building_from_robot, options.segment);
  MappedBuilding building;
  building.sensor = placed.kind;
  building.room_of_asr = rooms_of_asrs(placed, rooms.room_of_pose);
  building.doors = doors_of(placed, rooms);
  add_outlines(placed, grid, rooms, options, building);
  return building;
}

}  // namespace roomatlas
