// SPDX-License-Identifier: GPL-3.0-or-later
#include "outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "roomatlas/polyline/extract_points.hpp"
#include "roomatlas/polyline/region.hpp"
#include "roomatlas/polyline/simplify.hpp"

namespace roomatlas {
namespace {

constexpr int kCloseCells = 2;         // gaps between neighbouring beams
constexpr double kHalfPassageM = 0.5;  // what is seen through narrower gaps is another room
constexpr double kRegrowM = 0.25;      // gives corners back that the opening rounds off
constexpr double kBeyondDepthM = 0.8;  // how far the path's footprint reaches over a door line
constexpr double kJambReachM = 0.35;   // an outline point this near a jamb becomes the jamb

/// True for cells on the far side of a doorway, within reach of the robot's footprint.
bool is_beyond(const Exit& exit, const Point2& point_asr) {
  const Point2 relative = inverse(exit.asr_from_pivot) * point_asr;
  return relative.x() > 0.0 && relative.x() < kBeyondDepthM &&
         std::abs(relative.y()) < exit.width_m / 2.0 + 0.3;
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
  for_each_cell(closed.box, [&](const Cell& cell) {
    if (cleaned.at(cell) == CellState::occupied ||
        is_beyond_any(exits, cleaned.frame.center_of(cell))) {
      closed.set(cell, false);
    }
  });
  return closed;
}

CellMask both(CellMask first, const CellMask& second) {
  for (std::size_t i = 0; i < first.bits.size(); ++i) first.bits[i] &= second.bits[i];
  return first;
}

CellMask either(CellMask first, const CellMask& second) {
  for (std::size_t i = 0; i < first.bits.size(); ++i) first.bits[i] |= second.bits[i];
  return first;
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

/// The wall point nearest to a boundary's outer cell, if a wall stands within two cells.
std::optional<Point2> wall_near(const Cell& outside, const CellMap& cleaned, const HimmGrid& grid,
                                const RoomMapOptions& options) {
  constexpr int kReach = 2;
  std::optional<Cell> nearest;
  double nearest_cells = std::numeric_limits<double>::infinity();
  for_each_cell(
      {{outside.x - kReach, outside.y - kReach}, {outside.x + kReach + 1, outside.y + kReach + 1}},
      [&](const Cell& cell) {
        const double off = distance_cells(cell, outside);
        if (cleaned.at(cell) != CellState::occupied || off >= nearest_cells) return;
        nearest = cell;
        nearest_cells = off;
      });
  if (!nearest) return std::nullopt;
  return options.refine_points ? refined_point(*nearest, grid, options.epsilon)
                               : grid.frame().center_of(*nearest);
}

Ring boundary_points(const CellBoundary& boundary, const CellMap& cleaned, const HimmGrid& grid,
                     const RoomMapOptions& options) {
  Ring ring;
  for (std::size_t i = 0; i < boundary.edge_midpoints.size(); ++i) {
    const Point2 point = wall_near(boundary.outside_cells[i], cleaned, grid, options)
                             .value_or(boundary.edge_midpoints[i]);
    if (ring.empty() || (point - ring.back()).norm() > 1e-9) ring.push_back(point);
  }
  return ring;
}

/// Starts the ring at the point farthest from its middle: surely a corner.
void start_at_corner(Ring& ring) {
  const Box2 box = bounds(ring);
  const Point2 middle = (box.min + box.max) / 2.0;
  const auto corner = std::max_element(ring.begin(), ring.end(), [&](const auto& a, const auto& b) {
    return (a - middle).squaredNorm() < (b - middle).squaredNorm();
  });
  std::rotate(ring.begin(), corner, ring.end());
}

/// Moves the nearest ring point onto each jamb and returns the ascending indices of these points.
std::vector<std::size_t> pin_jambs(Ring& ring, const std::vector<Point2>& jambs) {
  std::vector<std::size_t> pinned;
  for (const Point2& jamb : jambs) {
    const auto nearest =
        std::min_element(ring.begin(), ring.end(), [&](const auto& a, const auto& b) {
          return (a - jamb).squaredNorm() < (b - jamb).squaredNorm();
        });
    if (nearest == ring.end() || (*nearest - jamb).norm() > kJambReachM) continue;
    *nearest = jamb;
    pinned.push_back(static_cast<std::size_t>(nearest - ring.begin()));
  }
  std::sort(pinned.begin(), pinned.end());
  pinned.erase(std::unique(pinned.begin(), pinned.end()), pinned.end());
  return pinned;
}

Ring simplified(Ring ring, const std::vector<Point2>& jambs, const RoomMapOptions& options) {
  if (ring.size() < 3) return ring;
  start_at_corner(ring);
  const std::vector<std::size_t> pinned = pin_jambs(ring, jambs);
  ring.push_back(ring.front());
  std::vector<std::size_t> kept = douglas_peucker(ring, options.simplify_tolerance_m, pinned);
  ring.pop_back();
  kept.pop_back();
  return fit_lines(ring, kept, options.fit, pinned, true).vertices;
}

}  // namespace

std::vector<Point2> jambs_of(const std::vector<Exit>& exits) {
  std::vector<Point2> jambs;
  for (const Exit& exit : exits) {
    if (exit.kind != PassageKind::doorway) continue;
    jambs.push_back(exit.jambs_asr.a);
    jambs.push_back(exit.jambs_asr.b);
  }
  return jambs;
}

Polygon outline_of(const HimmGrid& grid, const CellMap& cleaned,
                   const std::vector<PathSample>& path, const std::vector<Exit>& exits,
                   const RoomMapOptions& options) {
  const CellMask region = free_region(cleaned, path, exits, options);
  const std::vector<Point2> jambs = jambs_of(exits);
  Polygon outline;
  for (const CellBoundary& boundary : trace_boundaries(region, cleaned.frame)) {
    Ring ring = simplified(boundary_points(boundary, cleaned, grid, options), jambs, options);
    if (ring.size() < 3) continue;
    const bool is_hole = signed_area(boundary.edge_midpoints) < 0.0;
    if (is_hole) {
      outline.holes.push_back(std::move(ring));
    } else if (std::abs(signed_area(ring)) > std::abs(signed_area(outline.outer))) {
      outline.outer = std::move(ring);  // islands of the path (a lost scrap) do not count
    }
  }
  std::erase_if(outline.holes,
                [&](const Ring& hole) { return !contains(outline.outer, hole.front()); });
  return outline;
}

}  // namespace roomatlas
