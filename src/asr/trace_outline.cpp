// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/asr/trace_outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "roomatlas/polyline/simplify.hpp"

namespace roomatlas {
namespace {

constexpr double kJambReachM = 0.35;  // an outline point this near a jamb becomes the jamb
constexpr double kSamePointM = 1e-9;  // cells that share a wall cell give its point again

Ring boundary_points(const CellBoundary& boundary, const WallNear& wall_near) {
  Ring ring;
  for (std::size_t i = 0; i < boundary.edge_midpoints.size(); ++i) {
    const Point2 point = wall_near(boundary.outside_cells[i]).value_or(boundary.edge_midpoints[i]);
    if (ring.empty() || (point - ring.back()).norm() > kSamePointM) ring.push_back(point);
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

std::optional<Cell> nearest_wall_cell(const Cell& outside,
                                      const std::function<bool(const Cell&)>& is_wall) {
  constexpr int kReach = 2;  // cells: hits raise a band three wide; farther is another wall
  std::optional<Cell> nearest;
  double nearest_cells = std::numeric_limits<double>::infinity();
  for_each_cell(
      {{outside.x - kReach, outside.y - kReach}, {outside.x + kReach + 1, outside.y + kReach + 1}},
      [&](const Cell& cell) {
        const double off = distance_cells(cell, outside);
        if (off >= nearest_cells || !is_wall(cell)) return;
        nearest = cell;
        nearest_cells = off;
      });
  return nearest;
}

Polygon trace_outline(const CellMask& region, const CellFrame& frame, const WallNear& wall_near,
                      const std::vector<Point2>& jambs, const RoomMapOptions& options) {
  Polygon outline;
  for (const CellBoundary& boundary : trace_boundaries(region, frame)) {
    Ring ring = simplified(boundary_points(boundary, wall_near), jambs, options);
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
