// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/furniture.hpp"

#include <algorithm>
#include <cmath>

#include "roomatlas/grid/polygon_cells.hpp"
#include "roomatlas/planar/simplify.hpp"

namespace roomatlas {
namespace {

double distance_to_edge_m(const Polygon& room, const Point2& at) {
  double nearest_m = distance_to_boundary(room.outer, at);
  for (const Ring& hole : room.holes)
    nearest_m = std::min(nearest_m, distance_to_boundary(hole, at));
  return nearest_m;
}

/// Obstacles and unseen cells inside a room, off its edge.
CellMask inside(const Polygon& room, const Occupancy& occupancy, double off_wall_m) {
  const Box2 box = bounds(room.outer);
  CellMask mask(occupancy.seen.domain.within(
      {occupancy.frame.cell_of(box.min), occupancy.frame.cell_of(box.max)}));
  for_each_cell_in(room, occupancy.frame, mask.domain.bounds(), [&](const Cell& cell) {
    if (!mask.domain.contains(cell)) return;  // farther from all that was seen than furniture
    if (!occupancy.obstacle.at(cell) && occupancy.seen.at(cell)) return;
    mask.set(cell, distance_to_edge_m(room, occupancy.frame.center_of(cell)) > off_wall_m);
  });
  return eroded(dilated(mask, 1), 1);
}

/// Whether something was seen to stand along enough of a piece's edge. Else nobody looked there.
bool was_seen(const Ring& edge, const Occupancy& occupancy, double least_share) {
  const auto seen = std::count_if(edge.begin(), edge.end(), [&](const Point2& at) {
    const Cell cell = occupancy.frame.cell_of(at);
    bool is_near = false;
    for_each_cell({{cell.x - 1, cell.y - 1}, {cell.x + 2, cell.y + 2}},
                  [&](const Cell& near) { is_near = is_near || occupancy.obstacle.at(near); });
    return is_near;
  });
  return static_cast<double>(seen) >= least_share * static_cast<double>(edge.size());
}

/// Whether an outline comes near the room's edge.
bool stands_at_wall(const Ring& outline, const Polygon& room, double within_m) {
  return std::any_of(outline.begin(), outline.end(),
                     [&](const Point2& at) { return distance_to_edge_m(room, at) <= within_m; });
}

}  // namespace

std::vector<PlanFurniture> find_furniture(const std::vector<DraftedRoom>& rooms,
                                          const Occupancy& occupancy,
                                          const FurnitureOptions& options) {
  std::vector<PlanFurniture> furniture;
  for (const DraftedRoom& room : rooms) {
    const CellMask mask = inside(room.outline, occupancy, options.off_wall_m);
    for (const CellBoundary& boundary : trace_boundaries(mask, occupancy.frame)) {
      if (signed_area(boundary.edge_midpoints) < options.min_area_m2) continue;  // or a hole
      if (!was_seen(boundary.edge_midpoints, occupancy, options.seen_share)) continue;
      PlanFurniture piece;
      piece.outline.outer = planar::simplified(boundary.edge_midpoints, options.simplify_m);
      if (piece.outline.outer.size() < 3) continue;
      if (stands_at_wall(piece.outline.outer, room.outline, options.against_wall_m)) {
        piece.kind = FurnitureKind::against_wall;
      }
      furniture.push_back(std::move(piece));
    }
  }
  return furniture;
}

}  // namespace roomatlas
