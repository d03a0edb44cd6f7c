// SPDX-License-Identifier: GPL-3.0-or-later
#include "plans/route_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

namespace roomatlas::io {
namespace {

constexpr double kCell_m = 0.05;
constexpr double kMargin_m = 0.5;         // around the plan, and around a room for its doors
constexpr double kWished_m = 0.5;         // of clearance: what is nearer costs more
constexpr double kWeight = 2.0;           // of a cell that touches a wall, for each metre
constexpr double kKept_m = 0.3;           // of clearance that straightening leaves a way
constexpr double kNear_m = 2.0;           // how far a middle gives way to furniture
constexpr float kDiagonal = 1.41421356F;  // cells

/// Distance in metres to the nearest cell that is not free, along steps of king's moves: at most
/// 8 % more than Euclid's (two passes, Borgefors 1986).
CellGrid<float> clearances(const CellGrid<std::uint8_t>& cells) {
  CellGrid<float> out(cells.width(), cells.height(), 0.0F);
  constexpr float kFar = 1e6F;
  const auto relax = [&](int x, int y, int towards) {
    if (cells(x, y) != PlanRaster::kFree) return;
    float best = std::min(out.get(x - towards, y, 0.0F), out.get(x, y - towards, 0.0F)) + 1.0F;
    best = std::min(best, out.get(x - 1, y - towards, 0.0F) + kDiagonal);
    best = std::min(best, out.get(x + 1, y - towards, 0.0F) + kDiagonal);
    out(x, y) = std::min(towards > 0 ? kFar : out(x, y), best);
  };
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) relax(x, y, 1);
  }
  for (int y = cells.height() - 1; y >= 0; --y) {
    for (int x = cells.width() - 1; x >= 0; --x) relax(x, y, -1);
  }
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) out(x, y) *= static_cast<float>(kCell_m);
  }
  return out;
}

/// What is unknown behind a door that leads out of the plan is no wall to keep away from.
CellGrid<std::uint8_t> with_open_outside(const FloorPlan& plan, const PlanRaster& map) {
  CellGrid<std::uint8_t> cells = map.cells;
  for (const PlanDoor& door : plan.doors) {
    if (door.kind == DoorKind::window || (door.room_a && door.room_b)) continue;
    const Point2 at = ((door.jambs.a + door.jambs.b) / 2.0 - map.origin_m) / map.cell_m;
    const int reach = static_cast<int>(door.width_m / 2.0 / map.cell_m);
    const int x0 = static_cast<int>(at.x());
    const int y0 = static_cast<int>(at.y());
    for (int y = y0 - reach; y <= y0 + reach; ++y) {
      for (int x = x0 - reach; x <= x0 + reach; ++x) {
        if (cells.get(x, y, PlanRaster::kOccupied) == PlanRaster::kUnknown) {
          cells(x, y) = PlanRaster::kFree;
        }
      }
    }
  }
  return cells;
}

Box2 bounds_of(const PlanRoom& room) {
  Box2 box;
  for (const Polygon& part : room.parts) {
    for (const Point2& point : part.outer) box.extend(point);
  }
  return box;
}

}  // namespace

RouteCells::RouteCells(const FloorPlan& plan)
    : map_(raster_of(plan, kCell_m, kMargin_m)),
      clearance_m_(clearances(with_open_outside(plan, map_))),
      owner_(map_.cells.width(), map_.cells.height(), 0),
      plan_(plan) {
  for (int y = 0; y < owner_.height(); ++y) {
    for (int x = 0; x < owner_.width(); ++x) {
      if (map_.cells(x, y) != PlanRaster::kFree) clearance_m_(x, y) = 0.0F;
    }
  }
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
    for (const Polygon& part : plan.rooms[i].parts) {
      for_each_cell_in(part, map_, [&](int x, int y) { owner_(x, y) = static_cast<int>(i) + 1; });
    }
  }
}

RouteCells::Cell RouteCells::cell_of(const Point2& point) const {
  const Point2 at = (point - map_.origin_m) / map_.cell_m;
  return {static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))};
}

Point2 RouteCells::centre_of(const Cell& cell) const {
  return map_.origin_m + map_.cell_m * Point2(cell.x + 0.5, cell.y + 0.5);
}

void RouteCells::enter(const PlanRoom& room) {
  room_ = static_cast<int>(&room - plan_.rooms.data()) + 1;
  const Box2 box = bounds_of(room);
  if (box.empty()) {
    high_ = low_;
    return;
  }
  low_ = cell_of(box.min - Point2::Constant(kMargin_m));
  high_ = cell_of(box.max + Point2::Constant(kMargin_m));
  low_ = {std::max(low_.x, 0), std::max(low_.y, 0)};
  high_ = {std::min(high_.x + 1, owner_.width()), std::min(high_.y + 1, owner_.height())};
}

float RouteCells::clearance(const Cell& cell) const {
  if (cell.x < low_.x || cell.y < low_.y || cell.x >= high_.x || cell.y >= high_.y) return 0.0F;
  const int owner = owner_(cell.x, cell.y);
  return owner == 0 || owner == room_ ? clearance_m_(cell.x, cell.y) : 0.0F;
}

double RouteCells::clearance(const Segment2& line) const {
  const Point2 along = line.b - line.a;
  const int steps = std::max(1, static_cast<int>(std::ceil(2.0 * along.norm() / map_.cell_m)));
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i) {
    least = std::min<double>(least, clearance(cell_of(line.a + along * (1.0 * i / steps))));
  }
  return least;
}

bool RouteCells::is_open(const Point2& point) const {
  return clearance(cell_of(point)) > kClearance_m;
}

std::optional<Point2> RouteCells::nearest_open(const Point2& point) const {
  if (is_open(point)) return point;
  const Cell middle = cell_of(point);
  const int reach = static_cast<int>(kNear_m / map_.cell_m);
  std::optional<Point2> nearest;
  for (int y = middle.y - reach; y <= middle.y + reach; ++y) {
    for (int x = middle.x - reach; x <= middle.x + reach; ++x) {
      if (clearance({x, y}) <= kClearance_m) continue;
      const Point2 at = centre_of({x, y});
      if (!nearest || (at - point).norm() < (*nearest - point).norm()) nearest = at;
    }
  }
  return nearest;
}

Way RouteCells::pulled(const std::vector<Cell>& cells, const Point2& from, const Point2& to) const {
  Polyline points = {from};
  for (const Cell& cell : cells) points.push_back(centre_of(cell));
  points.push_back(to);
  Way way{{from}, 0.0, std::numeric_limits<double>::infinity()};
  for (std::size_t at = 0; at + 1 < points.size();) {
    // As far as one sees, without cutting corners closer than the way of cells does.
    std::size_t next = at + 1;
    double kept = clearance(Segment2{points[at], points[next]});
    double narrowest = std::min<double>(kKept_m, kept);
    for (std::size_t ahead = next + 1; ahead < points.size(); ++ahead) {
      narrowest = std::min<double>(narrowest, clearance(cell_of(points[ahead])));
      const double seen = clearance(Segment2{points[at], points[ahead]});
      if (seen < narrowest) break;
      next = ahead;
      kept = seen;
    }
    way.length_m += (points[next] - points[at]).norm();
    way.clearance_m = std::min(way.clearance_m, kept);
    way.line.push_back(points[next]);
    at = next;
  }
  return way;
}

std::optional<std::vector<RouteCells::Cell>> RouteCells::cells_between(const Cell& from,
                                                                       const Cell& to) const {
  constexpr std::array<std::array<int, 2>, 8> kMoves = {
      {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
  CellGrid<float> cost(high_.x - low_.x, high_.y - low_.y, std::numeric_limits<float>::infinity());
  CellGrid<std::uint8_t> came_by(cost.width(), cost.height());
  const auto left = [&](const Cell& at) {  // no way costs less
    const auto [few, many] = std::minmax({std::abs(to.x - at.x), std::abs(to.y - at.y)});
    return static_cast<float>(many - few) + kDiagonal * static_cast<float>(few);
  };
  // cost there and on, cost there, y, x: ties are always broken alike
  using Open = std::tuple<float, float, int, int>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  cost(from.x - low_.x, from.y - low_.y) = 0.0F;
  open.emplace(left(from), 0.0F, from.y, from.x);
  bool is_found = false;
  while (!open.empty() && !is_found) {
    const auto [whole, so_far, y, x] = open.top();
    open.pop();
    if (so_far > cost(x - low_.x, y - low_.y)) continue;
    is_found = x == to.x && y == to.y;
    for (std::size_t i = 0; i < kMoves.size(); ++i) {
      const Cell next{x + kMoves[i][0], y + kMoves[i][1]};
      const float free_m = clearance(next);
      if (free_m <= static_cast<float>(kClearance_m)) continue;
      const double tight = 1.0 - std::min<double>(free_m, kWished_m) / kWished_m;
      const float total =
          so_far + (i < 4 ? 1.0F : kDiagonal) * static_cast<float>(1.0 + kWeight * tight);
      float& best = cost(next.x - low_.x, next.y - low_.y);
      if (total >= best) continue;
      best = total;
      came_by(next.x - low_.x, next.y - low_.y) = static_cast<std::uint8_t>(i);
      open.emplace(total + left(next), total, next.y, next.x);
    }
  }
  if (!is_found) return std::nullopt;
  std::vector<Cell> between;
  for (Cell at = to; at.x != from.x || at.y != from.y;) {
    const auto& step = kMoves[came_by(at.x - low_.x, at.y - low_.y)];
    at = {at.x - step[0], at.y - step[1]};
    between.push_back(at);
  }
  if (!between.empty()) between.pop_back();  // where the way begins
  std::reverse(between.begin(), between.end());
  return between;
}

Way RouteCells::way(const Point2& from, const Point2& to) const {
  const auto between = cells_between(cell_of(from), cell_of(to));
  return between ? pulled(*between, from, to) : Way{};
}

}  // namespace roomatlas::io
