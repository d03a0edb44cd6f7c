// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "line_sums.hpp"
#include "roomatlas/draft/map_evidence.hpp"
#include "roomatlas/polyline/region.hpp"

namespace roomatlas {
namespace {

constexpr double kReach_m = 0.25;     // of boundary to each side that has one normal ...
constexpr double kLongReach_m = 1.0;  // ... and at most, where it is straight: the steps of a line
                                      // that runs nearly along the cells are long
constexpr double kStraightCells = 0.3;  // root mean square: a straight line of cells has up to 0.29
constexpr double kRough_m = 0.025;      // the same of what sensors drew, within `kReach_m`
constexpr int kFewest = 2;              // edges to each side; fewer have no direction
constexpr double kSpacing_m = 0.02;     // of points on an edge: as close as a laser's
constexpr double kWeight_per_m = 80.0;  // as many beams as a room that was looked at for a while

/// Sums over the first mid-points of a boundary, so that those of any stretch are differences.
struct Sums {
  LineSums midpoints;
  int breaks = 0;  ///< edges that are no obstacle's
};

/// A boundary of floor, unrolled beyond both ends of its ring.
class Boundary {
 public:
  /// @param is_wall of each edge
  Boundary(const CellBoundary& traced, const std::vector<char>& is_wall, double cell_m)
      : traced_(traced), cell_m_(cell_m), count_(is_wall.size()) {
    most_ =
        std::min(static_cast<std::size_t>(std::lround(kLongReach_m / cell_m)), (count_ - 1) / 2);
    most_ = std::max(most_, std::min(static_cast<std::size_t>(kFewest), (count_ - 1) / 2));
    const Point2 origin = traced.edge_midpoints.front();
    sums_.resize(count_ + 2 * most_ + 1);
    for (std::size_t i = 0; i + 1 < sums_.size(); ++i) {
      const std::size_t edge = edge_of(i);
      Sums& next = sums_[i + 1] = sums_[i];
      next.midpoints.add(traced.edge_midpoints[edge] - origin);
      if (is_wall[edge] == 0) ++next.breaks;
    }
  }

  /// The line of the longest stretch around an edge that is straight; nothing in corners.
  [[nodiscard]] std::optional<FittedLine> line_at(std::size_t edge) const {
    std::optional<FittedLine> straight;
    std::optional<FittedLine> rough;
    for (auto reach = static_cast<std::size_t>(kFewest); reach <= most_;
         reach = std::max(reach + 1, reach * 3 / 2)) {
      const auto line = line_of(edge + most_ - reach, edge + most_ + reach);
      if (!line) break;
      const bool is_near = static_cast<double>(reach) * cell_m_ <= kReach_m + 1e-9 ||
                           reach <= static_cast<std::size_t>(kFewest);
      if (line->rms_m <= kStraightCells * cell_m_) straight = line;
      if (is_near && line->rms_m <= std::max(kRough_m, kStraightCells * cell_m_)) rough = line;
    }
    return straight ? straight : rough;
  }

 private:
  [[nodiscard]] std::size_t edge_of(std::size_t unrolled) const {
    return (unrolled + count_ - most_) % count_;
  }

  /// Total least squares; nothing across edges that are no obstacle's.
  [[nodiscard]] std::optional<FittedLine> line_of(std::size_t first, std::size_t last) const {
    const Sums& from = sums_[first];
    const Sums& to = sums_[last + 1];
    if (from.breaks != to.breaks) return std::nullopt;
    FittedLine line = (to.midpoints - from.midpoints).line();
    line.middle += traced_.edge_midpoints.front();
    return line;
  }

  const CellBoundary& traced_;
  double cell_m_;
  std::size_t count_;
  std::size_t most_ = 0;
  std::vector<Sums> sums_;
};

/// Adds the points of one edge, moved onto the line.
void add_points(const MapCells& map, const Point2& midpoint, const Cell& outside,
                const FittedLine& line, std::vector<SurfacePoint>& points) {
  const Point2 along = direction(line.direction_rad);
  const Point2 inwards = midpoint - map.frame.center_of(outside);
  Point2 normal(-along.y(), along.x());
  if (normal.dot(inwards) < 0.0) normal = -normal;
  const Point2 at = line.middle + (midpoint - line.middle).dot(along) * along;
  // An edge covers so much of its line.
  const double cell_m = map.frame.cell_m;
  const double covered_m = cell_m * normal.dot(2.0 * inwards / cell_m);
  const int count = std::max(1, static_cast<int>(std::ceil(cell_m / kSpacing_m - 1e-9)));
  const double weight = kWeight_per_m * std::max(0.2 * cell_m, covered_m) / count;
  for (int i = 0; i < count; ++i) {
    const double off_m = covered_m * ((i + 0.5) / count - 0.5);
    points.push_back({at + off_m * along, std::atan2(normal.y(), normal.x()), weight});
  }
}

}  // namespace

std::vector<SurfacePoint> surfaces_of(const MapCells& map) {
  CellMask floor(map.cells.domain);
  for_each_cell(floor.domain,
                [&](const Cell& cell) { floor.set(cell, map.cells[cell] == MapCell::free); });
  std::vector<SurfacePoint> points;
  for (const CellBoundary& traced : trace_boundaries(floor, map.frame)) {
    const std::size_t count = traced.edge_midpoints.size();
    std::vector<char> wall(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
      wall[i] = map.cells.get(traced.outside_cells[i]) == MapCell::occupied ? 1 : 0;
    }
    const Boundary boundary(traced, wall, map.frame.cell_m);
    for (std::size_t i = 0; i < count; ++i) {
      if (wall[i] == 0) continue;
      const auto line = boundary.line_at(i);
      if (line) add_points(map, traced.edge_midpoints[i], traced.outside_cells[i], *line, points);
    }
  }
  return points;
}

}  // namespace roomatlas
