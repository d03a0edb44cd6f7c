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

}  // namespace

RoomRaster::RoomRaster(const FloorPlan& plan, double step_m)
    : step_m_(step_m), points_(plan.rooms.size()) {
  Box2 box;
  for (const PlanRoom& room : plan.rooms) {
    for (const Polygon& part : room.parts) {
      for (const Point2& point : part.outer) box.extend(point);
    }
  }
  if (box.empty()) return;
  origin_ = box.min;
  columns_ = static_cast<int>(std::ceil(box.size().x() / step_m)) + 1;
  rows_ = static_cast<int>(std::ceil(box.size().y() / step_m)) + 1;
  labels_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), -1);
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) fill(plan.rooms[i], static_cast<int>(i));
}

void RoomRaster::fill(const PlanRoom& room, int index) {
  for (const Polygon& part : room.parts) {
    for (int row = 0; row < rows_; ++row) {
      const double y = origin_.y() + (row + 0.5) * step_m_;
      const std::vector<double> xs = crossings_at(part, y);
      for (std::size_t i = 0; i + 1 < xs.size(); i += 2) {
        const int from = static_cast<int>(std::ceil((xs[i] - origin_.x()) / step_m_ - 0.5));
        const int to = static_cast<int>(std::ceil((xs[i + 1] - origin_.x()) / step_m_ - 0.5));
        for (int column = std::max(from, 0); column < std::min(to, columns_); ++column) {
          labels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)] = index;
          points_[static_cast<std::size_t>(index)].push_back(
              {origin_.x() + (column + 0.5) * step_m_, y});
        }
      }
    }
  }
}

int RoomRaster::room_at(const Point2& point) const {
  const double column = std::floor((point.x() - origin_.x()) / step_m_);
  const double row = std::floor((point.y() - origin_.y()) / step_m_);
  if (!(column >= 0 && column < columns_ && row >= 0 && row < rows_)) return -1;
  return labels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                 static_cast<std::size_t>(column)];
}

Point2 centre_of(const std::vector<Point2>& points) {
  Point2 sum = Point2::Zero();
  for (const Point2& point : points) sum += point;
  return points.empty() ? sum : Point2(sum / static_cast<double>(points.size()));
}

}  // namespace roomatlas
