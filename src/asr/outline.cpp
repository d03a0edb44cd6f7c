// SPDX-License-Identifier: GPL-3.0-or-later
#include "outline.hpp"

#include <algorithm>
#include <cmath>

#include "roomatlas/asr/trace_outline.hpp"
#include "roomatlas/polyline/extract_points.hpp"
#include "roomatlas/polyline/region.hpp"

namespace roomatlas {
namespace {

constexpr int kCloseCells = 2;         // gaps between neighbouring beams
constexpr double kHalfPassageM = 0.5;  // what is seen through narrower gaps is another room
constexpr double kRegrowM = 0.25;      // gives corners back that the opening rounds off
constexpr double kBeyondDepthM = 0.8;  // how far the path's footprint reaches over a door line ...
constexpr double kBeyondAsideM = 0.3;  // ... and past a jamb; larger cuts off floor beside the door

/// True for cells on the far side of a doorway, within reach of the robot's footprint.
bool is_beyond(const Exit& exit, const Point2& point_asr) {
  const Point2 relative = inverse(exit.frame_from_pivot) * point_asr;
  return relative.x() > 0.0 && relative.x() < kBeyondDepthM &&
         std::abs(relative.y()) < exit.width_m / 2.0 + kBeyondAsideM;
}

bool is_beyond_any(const std::vector<Exit>& exits, const Point2& point_asr) {
  return std::any_of(exits.begin(), exits.end(), [&](const Exit& exit) {
    return exit.kind == PassageKind::doorway && is_beyond(exit, point_asr);
  });
}

/// Free cells of this side of the doors: empty or path, small gaps between beams closed.
CellMask free_cells(const CellMap& cleaned, const std::vector<Exit>& exits) {
  CellMask free(cleaned.box);
  for_each_cell(cleaned.box, [&](const Cell& cell) {
    const CellState state = cleaned.at(cell);
    free.set(cell, state == CellState::empty || state == CellState::robot_path);
  });
  CellMask closed = eroded(dilated(free, kCloseCells), kCloseCells);
  for_each_cell(closed.domain, [&](const Cell& cell) {
    if (cleaned.at(cell) == CellState::occupied ||
        is_beyond_any(exits, cleaned.frame.center_of(cell))) {
      closed.set(cell, false);
    }
  });
  return closed;
}

/// The free space that the path is in. Space that only opens up behind a gap narrower than a
/// passage was seen from here, but belongs to a room that the robot did not enter here.
CellMask free_region(const CellMap& cleaned, const std::vector<PathSample>& path,
                     const std::vector<Exit>& exits, const RoomMapOptions& options) {
  const CellMask free = free_cells(cleaned, exits);
  const auto cells = [&](double length_m) {
    return static_cast<int>(std::lround(length_m / options.cell_m));
  };
  CellMask on_path(cleaned.box);
  std::vector<Cell> seeds;
  for (const PathSample& sample : path) {
    seeds.push_back(cleaned.frame.cell_of(sample.asr_from_robot.position()));
    on_path.set(seeds.back(), true);
  }
  const int half = cells(kHalfPassageM);
  const CellMask wide = both(dilated(eroded(free, half), half), free);
  const CellMask around_path = both(dilated(on_path, half), free);
  const CellMask region = connected_to(either(wide, around_path), seeds);
  const CellMask regrown = both(dilated(region, cells(kRegrowM)), free);
  const auto hole_cells =
      static_cast<std::int64_t>(options.min_hole_m2 / (options.cell_m * options.cell_m));
  return holes_filled(connected_to(regrown, seeds), hole_cells);
}

}  // namespace

std::vector<Point2> jambs_of(const std::vector<Exit>& exits) {
  std::vector<Point2> jambs;
  for (const Exit& exit : exits) {
    if (exit.kind != PassageKind::doorway) continue;
    jambs.push_back(exit.jambs.a);
    jambs.push_back(exit.jambs.b);
  }
  return jambs;
}

Polygon outline_of(const HimmGrid& grid, const CellMap& cleaned,
                   const std::vector<PathSample>& path, const std::vector<Exit>& exits,
                   const RoomMapOptions& options) {
  const CellMask region = free_region(cleaned, path, exits, options);
  const auto is_wall = [&](const Cell& cell) { return cleaned.at(cell) == CellState::occupied; };
  const WallNear wall_near = [&](const Cell& outside) -> std::optional<Point2> {
    const std::optional<Cell> wall = nearest_wall_cell(outside, is_wall);
    if (!wall) return std::nullopt;
    return options.refine_points ? refined_point(*wall, grid, options.epsilon)
                                 : cleaned.frame.center_of(*wall);
  };
  return trace_outline(region, cleaned.frame, wall_near, jambs_of(exits), options);
}

}  // namespace roomatlas
