// SPDX-License-Identifier: GPL-3.0-or-later
#include "walk_ways.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <queue>
#include <tuple>

#include "floor_cells.hpp"
#include "roomatlas/polyline/distance_field.hpp"

namespace roomatlas {
namespace {

constexpr double kCellM = 0.1;       // larger misses doors
constexpr double kClearanceM = 0.3;  // of a person's middle; a cell more than the radius
constexpr double kEasyM = 0.6;       // nearer to walls people go only where they must
constexpr float kTightPrice = 3.0F;  // what a metre there costs
constexpr int kBesideCells = 4;      // how far a place that is walked on may be looked for
constexpr double kFarShare = 0.8;    // of a way's length: where it may end

CellBox box_of(const FloorPlan& world, const CellFrame& frame) {
  Box2 bound;
  for (const Polygon& body : bodies_of(world)) {
    for (const Point2& corner : body.outer) bound.extend(corner);
  }
  if (bound.empty()) return {};
  const Cell high = frame.cell_of(bound.max);
  return {frame.cell_of(bound.min), {high.x + 1, high.y + 1}};
}

CellMask floor_of(const FloorPlan& world, const CellFrame& frame, const CellBox& box) {
  CellMask floor(box);
  floor.bits.assign(floor.bits.size(), 1);
  const auto close = [&](const Cell& cell) { floor.set(cell, false); };
  const std::vector<Polygon> bodies = bodies_of(world);
  for (const Polygon& body : bodies) for_each_cell_in(body, frame, box, close);
  // Thin ones, such as leaves, may have no cell's middle in them.
  for (const Segment2& edge : edges_of(bodies)) {
    for_each_cell(cells_around({edge.a, edge.b}, kCellM, frame, box), [&](const Cell& cell) {
      if (distance(edge, frame.center_of(cell)) <= kCellM / 2.0) close(cell);
    });
  }
  return floor;
}

}  // namespace

WalkWays::WalkWays(const FloorPlan& world, const Point2& start)
    : frame_{kCellM}, clearance_(distance_inside(floor_of(world, frame_, box_of(world, frame_)))) {
  for (float& value : clearance_.values) value *= static_cast<float>(kCellM);
  is_walked_ = Raster<std::uint8_t>(clearance_.box, 1);
  visits_ = Raster<Visit>(clearance_.box);
  const auto first = cell_near(start);
  is_walked_ = Raster<std::uint8_t>(clearance_.box, 0);
  if (!first) return;
  std::vector<Cell> open = {*first};
  while (!open.empty()) {
    const Cell cell = open.back();
    open.pop_back();
    if (clearance_.get(cell) < kClearanceM || is_walked_[cell] != 0) continue;
    is_walked_[cell] = 1;
    for (const auto& [dx, dy] :
         {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
      open.push_back({cell.x + dx, cell.y + dy});
    }
  }
  for_each_cell(clearance_.box, [&](const Cell& cell) {
    if (is_walked_[cell] != 0) cells_.push_back(cell);
  });
}

bool WalkWays::is_walked(const Point2& at) const { return is_walked_.get(frame_.cell_of(at)) != 0; }

std::optional<Point2> WalkWays::place(double share) const {
  if (cells_.empty()) return std::nullopt;
  return frame_.center_of(
      cells_[static_cast<std::size_t>(share * static_cast<double>(cells_.size()))]);
}

std::optional<Cell> WalkWays::cell_near(const Point2& at) const {
  const Cell middle = frame_.cell_of(at);
  std::optional<Cell> best;
  for_each_cell({{middle.x - kBesideCells, middle.y - kBesideCells},
                 {middle.x + kBesideCells + 1, middle.y + kBesideCells + 1}},
                [&](const Cell& cell) {
                  if (clearance_.get(cell) < kClearanceM || is_walked_.get(cell) == 0) return;
                  if (best && distance_cells(cell, middle) >= distance_cells(*best, middle)) return;
                  best = cell;
                });
  return best;
}

std::vector<Cell> WalkWays::cells_within(const Cell& start, double length_m) {
  ++search_;
  std::vector<Cell> reached;
  using Entry = std::tuple<float, int, int>;  // cost, y, x: ties go by cell
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  visits_[start] = {search_, false, 0.0F, start};
  queue.emplace(0.0F, start.y, start.x);
  while (!queue.empty()) {
    const auto [cost_m, y, x] = queue.top();
    queue.pop();
    const Cell cell{x, y};
    if (visits_[cell].done) continue;
    if (cost_m > static_cast<float>(length_m)) break;
    visits_[cell].done = true;
    reached.push_back(cell);
    for_each_cell({{x - 1, y - 1}, {x + 2, y + 2}}, [&, cost = cost_m](const Cell& next) {
      if (is_walked_.get(next) == 0) return;
      const double step_m =
          kCellM * (next.x == cell.x || next.y == cell.y ? 1.0 : std::numbers::sqrt2);
      const float price = clearance_[next] < kEasyM ? kTightPrice : 1.0F;
      const float there_m = cost + price * static_cast<float>(step_m);
      Visit& visit = visits_[next];
      if (visit.search == search_ && (visit.done || visit.cost_m <= there_m)) return;
      visit = {search_, false, there_m, cell};
      queue.emplace(there_m, next.y, next.x);
    });
  }
  return reached;
}

Polyline WalkWays::way_from(const Point2& from, double length_m, double share) {
  const auto start = cell_near(from);
  if (!start) return {};
  const std::vector<Cell> reached = cells_within(*start, length_m);
  const auto far = std::partition_point(reached.begin(), reached.end(), [&](const Cell& cell) {
    return visits_[cell].cost_m < static_cast<float>(kFarShare * length_m);
  });
  const auto first = far == reached.end() ? reached.begin() : far;
  const auto count = static_cast<double>(reached.end() - first);
  Cell at = first[static_cast<std::ptrdiff_t>(share * count)];
  Polyline way = {frame_.center_of(at)};
  while (at != *start) {
    at = visits_[at].from;
    way.push_back(frame_.center_of(at));
  }
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace roomatlas
