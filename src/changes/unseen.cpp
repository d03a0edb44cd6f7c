// SPDX-License-Identifier: GPL-3.0-or-later
#include "unseen.hpp"

#include <algorithm>

#include "roomatlas/planar/simplify.hpp"

namespace roomatlas::changes {
namespace {

constexpr std::size_t kLeastPoses = 5;  // of who was in a room; fewer looked around its door
constexpr double kInside_m = 0.3;       // from the room's edge: the robot stood in its door
constexpr double kSimplify_m = 0.05;

bool lies_in(const PlanRoom& room, const Point2& point, double inside_m) {
  return std::any_of(room.parts.begin(), room.parts.end(), [&](const Polygon& part) {
    if (!contains(part, point) || distance_to_boundary(part.outer, point) < inside_m) return false;
    return std::none_of(part.holes.begin(), part.holes.end(), [&](const Ring& hole) {
      return distance_to_boundary(hole, point) < inside_m;
    });
  });
}

bool is_entered(const PlanRoom& room, const std::vector<Pose2>& path) {
  std::size_t inside = 0;
  for (const Pose2& pose : path) {
    if (lies_in(room, pose.position(), kInside_m) && ++inside >= kLeastPoses) return true;
  }
  return false;
}

CellBox box_of(const PlanRoom& room, const CellFrame& frame) {
  Box2 box;
  for (const Polygon& part : room.parts) {
    for (const Point2& point : part.outer) box.extend(point);
  }
  if (box.empty()) return {};
  const Cell high = frame.cell_of(box.max);
  return {frame.cell_of(box.min), {high.x + 1, high.y + 1}};
}

/// Of the floor that one mission saw in a room, the share that the other saw too.
double seen_share(const PlanRoom& room, const SeenCells& one, const SeenCells& other,
                  const CellFrame& frame) {
  std::int64_t all = 0;
  std::int64_t again = 0;
  for_each_cell(one.seen.domain.within(box_of(room, frame)), [&](const Cell& cell) {
    if (!one.seen.at(cell) || !lies_in(room, frame.center_of(cell), 0.0)) return;
    ++all;
    if (other.seen.at(cell)) ++again;
  });
  return all > 0 ? static_cast<double>(again) / static_cast<double>(all) : 0.0;
}

void add_rooms(const Seen& one, const Seen& other, bool is_before, const CellFrame& frame,
               std::vector<OneSidedRoom>& rooms) {
  for (const PlanRoom& room : one.plan.rooms) {
    if (!is_entered(room, one.path) || is_entered(room, other.path)) continue;
    rooms.push_back({room.id, room.name, is_before, room.area_m2,
                     seen_share(room, one.cells, other.cells, frame)});
  }
}

/// The outlines of a mask as polygons with their holes; small ones are left out.
std::vector<Polygon> polygons_of(const CellMask& mask, const CellFrame& frame, double min_m2) {
  std::vector<Polygon> polygons;
  std::vector<Ring> holes;
  for (const CellBoundary& boundary : trace_boundaries(mask, frame)) {
    const double area_m2 = signed_area(boundary.edge_midpoints);
    if (std::abs(area_m2) < min_m2) continue;
    Ring ring = planar::simplified(boundary.edge_midpoints, kSimplify_m);
    if (area_m2 > 0.0) {
      polygons.push_back({std::move(ring), {}});
    } else {
      holes.push_back(std::move(ring));
    }
  }
  for (Ring& hole : holes) {
    const auto around = std::find_if(polygons.begin(), polygons.end(), [&](const Polygon& polygon) {
      return contains(polygon.outer, hole.front());
    });
    if (around != polygons.end()) around->holes.push_back(std::move(hole));
  }
  return polygons;
}

}  // namespace

std::vector<OneSidedRoom> one_sided_rooms(const Seen& before, const Seen& after,
                                          const CellFrame& frame) {
  std::vector<OneSidedRoom> rooms;
  add_rooms(before, after, true, frame, rooms);
  add_rooms(after, before, false, frame, rooms);
  return rooms;
}

std::vector<Polygon> not_seen_again(const Seen& before, const SeenCells& after,
                                    const CellFrame& frame, const ChangeOptions& options) {
  CellMask lost(before.cells.seen.domain);
  for (const PlanRoom& room : before.plan.rooms) {
    const CellDomain& seen = before.cells.seen.domain;
    for_each_cell(seen.within(box_of(room, frame)), [&](const Cell& cell) {
      if (!before.cells.seen.at(cell) || after.seen.at(cell)) return;
      if (lies_in(room, frame.center_of(cell), 0.0)) lost.set(cell, true);
    });
  }
  return polygons_of(dilated(eroded(lost, 1), 1), frame, options.min_unseen_m2);
}

}  // namespace roomatlas::changes
