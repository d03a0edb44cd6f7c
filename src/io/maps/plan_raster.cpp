// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_raster.hpp"

#include "roomatlas/core/issue.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas::io {
namespace {

constexpr double kMostCells = 268435456.0;  // 2^28

Box2 box_of(const FloorPlan& plan) {
  Box2 box;
  const auto extend = [&](const Ring& ring) {
    for (const Point2& point : ring) {
      if (point.allFinite()) box.extend(point);
    }
  };
  for (const PlanRoom& room : plan.rooms) {
    for (const Polygon& part : room.parts) extend(part.outer);
  }
  for (const Polygon& wall : plan.walls) extend(wall.outer);
  for (const PlanDoor& door : plan.doors) extend(door.opening);
  return box;
}

/// The lower left corner, on a whole number of cells.
Point2 origin_of(const Box2& box, double cell_m, double margin_m) {
  const auto whole = [&](double value) { return std::floor(value / cell_m + 1e-6) * cell_m; };
  return Point2(box.min - Point2::Constant(margin_m)).unaryExpr(whole);
}

/// Columns and rows; too many for an integer, perhaps.
Point2 size_of(const Box2& box, double cell_m, double margin_m) {
  const Point2 high = box.max + Point2::Constant(margin_m);
  return ((high - origin_of(box, cell_m, margin_m)) / cell_m).array().ceil();
}

/// Paints on a raster.
class Painter {
 public:
  explicit Painter(PlanRaster& raster) : raster_(raster) {}

  void fill(const Polygon& polygon, std::uint8_t value) {
    for_each_cell_in(polygon, raster_, [&](int x, int y) { raster_.cells(x, y) = value; });
  }

  /// The cells that the ring's edges run through.
  void trace(const Ring& ring, std::uint8_t value) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      trace_line({ring[i], ring[(i + 1) % ring.size()]}, value);
  }

  /// Where a door opens into its rooms, but for two cells at each jamb. A wall whose ring passes
  /// from jamb to jamb without breadth must not shut it.
  void open_faces(const PlanDoor& door) {
    const Point2 jambs = (door.jambs.b - door.jambs.a).normalized();
    for (std::size_t i = 0; i < door.opening.size(); ++i) {
      const Point2& from = door.opening[i];
      const Point2& to = door.opening[(i + 1) % door.opening.size()];
      const double length_m = (to - from).norm();
      if (length_m <= 4.0 * raster_.cell_m) continue;
      const Point2 along = (to - from) / length_m;
      if (std::abs(along.dot(jambs)) < 0.7) continue;  // a jamb
      const Point2 kept = 2.0 * raster_.cell_m * along;
      trace_line({from + kept, to - kept}, PlanRaster::kFree);
    }
  }

 private:
  void trace_line(const Segment2& line, std::uint8_t value) {
    const Point2 along = line.b - line.a;
    const int steps = static_cast<int>(std::ceil(along.norm() / (raster_.cell_m / 4.0))) + 1;
    for (int step = 0; step <= steps; ++step) {
      const Point2 at = line.a + along * (static_cast<double>(step) / steps);
      const int x = cell(at.x(), 0);
      const int y = cell(at.y(), 1) - raster_.first_row;
      if (raster_.cells.has(x, y)) raster_.cells(x, y) = value;
    }
  }

  [[nodiscard]] int cell(double at_m, int axis) const {
    return static_cast<int>(std::floor((at_m - raster_.origin_m[axis]) / raster_.cell_m));
  }

  PlanRaster& raster_;
};

/// Where the ring's edges cross a height.
void add_crossings(const Ring& ring, double y_m, std::vector<double>& crossings) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2& a = ring[i];
    const Point2& b = ring[(i + 1) % ring.size()];
    if ((a.y() <= y_m) == (b.y() <= y_m)) continue;
    crossings.push_back(a.x() + (y_m - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
}

}  // namespace

void for_each_cell_in(const Polygon& polygon, const PlanRaster& raster,
                      const std::function<void(int x, int y)>& visit) {
  const Box2 box = bounds(polygon.outer);
  if (box.empty()) return;
  const auto row = [&](double y_m) {
    return static_cast<int>(std::floor((y_m - raster.origin_m.y()) / raster.cell_m));
  };
  const auto column = [&](double x_m) {
    return static_cast<int>(std::ceil((x_m - raster.origin_m.x()) / raster.cell_m - 0.5));
  };
  const int end_row = raster.first_row + raster.cells.height();
  const int last_row = std::min(end_row - 1, row(box.max.y()));
  std::vector<double> crossings;
  for (int y = std::max(raster.first_row, row(box.min.y())); y <= last_row; ++y) {
    const double at_m = raster.origin_m.y() + (y + 0.5) * raster.cell_m;
    crossings.clear();
    add_crossings(polygon.outer, at_m, crossings);
    for (const Ring& hole : polygon.holes) add_crossings(hole, at_m, crossings);
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const int end = std::min(raster.cells.width(), column(crossings[i + 1]));
      for (int x = std::max(0, column(crossings[i])); x < end; ++x) {
        visit(x, y - raster.first_row);
      }
    }
  }
}

bool is_too_large(const FloorPlan& plan, double cell_m, double margin_m) {
  const Box2 box = box_of(plan);
  if (box.empty()) return false;
  const Point2 size = size_of(box, cell_m, margin_m);
  return size.x() * size.y() > kMostCells;
}

RasterFrame frame_of(const FloorPlan& plan, double cell_m, double margin_m) {
  RasterFrame frame;
  frame.cell_m = cell_m;
  const Box2 box = box_of(plan);
  if (box.empty()) return frame;
  frame.origin_m = origin_of(box, cell_m, margin_m);
  const Point2 size = size_of(box, cell_m, margin_m);
  if (is_too_large(plan, cell_m, margin_m)) {
    throw InputError("the plan is too large for a map of cells: it would have " +
                     std::to_string(std::llround(size.x() * size.y())) +
                     " cells; the most is 268435456");
  }
  frame.width = static_cast<int>(size.x());
  frame.height = static_cast<int>(size.y());
  return frame;
}

PlanRaster rows_of(const FloorPlan& plan, const RasterFrame& frame, int first_row, int rows) {
  PlanRaster raster{frame.origin_m, frame.cell_m, first_row,
                    CellGrid<std::uint8_t>(frame.width, rows, PlanRaster::kUnknown)};
  Painter painter(raster);
  for (const PlanRoom& room : plan.rooms) {
    for (const Polygon& part : room.parts) painter.fill(part, PlanRaster::kFree);
  }
  for (const Polygon& wall : plan.walls) {
    painter.fill(wall, PlanRaster::kOccupied);
    painter.trace(wall.outer, PlanRaster::kOccupied);
    for (const Ring& hole : wall.holes) painter.trace(hole, PlanRaster::kOccupied);
  }
  for (const PlanDoor& door : plan.doors) {
    painter.fill({door.opening, {}}, PlanRaster::kFree);
    painter.open_faces(door);
  }
  for (const Polygon& piece : outlines_of(plan.furniture)) {
    painter.fill(piece, PlanRaster::kOccupied);
    painter.trace(piece.outer, PlanRaster::kOccupied);
  }
  return raster;
}

PlanRaster raster_of(const FloorPlan& plan, double cell_m, double margin_m) {
  const RasterFrame frame = frame_of(plan, cell_m, margin_m);
  return rows_of(plan, frame, 0, frame.height);
}

}  // namespace roomatlas::io
