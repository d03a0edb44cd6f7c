// SPDX-License-Identifier: GPL-3.0-or-later
#include "room_raster.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

/// Where the line at height y meets the polygon's edges, from left to right: inside lies between
/// each two (even-odd).
std::vector<double> crossings_at(const Polygon& polygon, double y) {
  std::vector<double> xs;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2& a = ring[i];
      const Point2& b = ring[(i + 1) % ring.size()];
      if ((a.y() <= y) == (b.y() <= y)) continue;
      xs.push_back(a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
    }
  };
  add(polygon.outer);
  for (const Ring& hole : polygon.holes) add(hole);
  std::sort(xs.begin(), xs.end());
  return xs;
}

std::int64_t step_of(double metres, double step_m) {
  return static_cast<std::int64_t>(std::floor(metres / step_m));
}

}  // namespace

std::vector<LatticeCell> cells_in(const Polygon& polygon, double step_m) {
  const Box2 box = bounds(polygon.outer);
  std::vector<LatticeCell> cells;
  if (box.empty()) return cells;
  const std::int64_t last_row = step_of(box.max.y(), step_m);
  for (std::int64_t row = step_of(box.min.y(), step_m); row <= last_row; ++row) {
    const std::vector<double> xs = crossings_at(polygon, (static_cast<double>(row) + 0.5) * step_m);
    for (std::size_t i = 0; i + 1 < xs.size(); i += 2) {
      // The first middle at or right of the crossing.
      const auto from = static_cast<std::int64_t>(std::ceil(xs[i] / step_m - 0.5));
      const auto to = static_cast<std::int64_t>(std::ceil(xs[i + 1] / step_m - 0.5));
      for (std::int64_t column = from; column < to; ++column) cells.push_back({column, row});
    }
  }
  return cells;
}

RoomRaster::RoomRaster(const FloorPlan& plan, double step_m)
    : step_m_(step_m), points_(plan.rooms.size()) {
  Box2 box;
  for (const PlanRoom& room : plan.rooms) {
    for (const Polygon& part : room.parts) {
      for (const Point2& point : part.outer) box.extend(point);
    }
  }
  if (box.empty()) return;
  low_ = {step_of(box.min.x(), step_m), step_of(box.min.y(), step_m)};
  columns_ = step_of(box.max.x(), step_m) - low_.column + 1;
  rows_ = step_of(box.max.y(), step_m) - low_.row + 1;
  labels_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), -1);
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) fill(plan.rooms[i], static_cast<int>(i));
}

void RoomRaster::fill(const PlanRoom& room, int index) {
  std::vector<Point2>& points = points_[static_cast<std::size_t>(index)];
  for (const Polygon& part : room.parts) {
    for (const LatticeCell& cell : cells_in(part, step_m_)) {
      labels_[*slot(cell)] = index;
      points.emplace_back((static_cast<double>(cell.column) + 0.5) * step_m_,
                          (static_cast<double>(cell.row) + 0.5) * step_m_);
    }
  }
}

std::optional<std::size_t> RoomRaster::slot(const LatticeCell& cell) const {
  const std::int64_t column = cell.column - low_.column;
  const std::int64_t row = cell.row - low_.row;
  if (column < 0 || column >= columns_ || row < 0 || row >= rows_) return std::nullopt;
  return static_cast<std::size_t>(row * columns_ + column);
}

int RoomRaster::room_at(const Point2& point) const {
  const auto here = slot({step_of(point.x(), step_m_), step_of(point.y(), step_m_)});
  return here ? labels_[*here] : -1;
}

Point2 centre_of(const std::vector<Point2>& points) {
  Point2 sum = Point2::Zero();
  for (const Point2& point : points) sum += point;
  return points.empty() ? sum : Point2(sum / static_cast<double>(points.size()));
}

}  // namespace roomatlas
