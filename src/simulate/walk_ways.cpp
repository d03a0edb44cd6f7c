// SPDX-License-Identifier: GPL-3.0-or-later
#include "walk_ways.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>

#include "obstacles.hpp"
#include "roomatlas/grid/polygon_cells.hpp"
#include "roomatlas/polyline/distance_field.hpp"

namespace roomatlas {
namespace {

constexpr float kTightPrice = 3.0F;       // what a metre there costs
constexpr int kBesideCells = 4;           // how far a place that is walked on may be looked for
constexpr std::size_t kLongestCut = 200;  // cells of a way that one straight line may replace
constexpr double kFarShare = 0.8;         // of a way's length: where it may end

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
    for_each_cell(cells_around({edge.a, edge.b}, frame.cell_m, frame, box), [&](const Cell& cell) {
      if (distance(edge, frame.center_of(cell)) <= 0.71 * frame.cell_m) close(cell);
    });
  }
  return floor;
}

}  // namespace

WalkWays::WalkWays(const FloorPlan& world, const Point2& start, const WalkOptions& options)
    : options_(options),
      frame_{options.cell_m},
      clearance_(distance_inside(floor_of(world, frame_, box_of(world, frame_)))) {
  for (float& value : clearance_.values) value *= static_cast<float>(options.cell_m);
  is_walked_ = Raster<std::uint8_t>(clearance_.domain, 1);
  visits_ = Raster<Visit>(clearance_.domain);
  const auto first = cell_near(start);
  is_walked_ = Raster<std::uint8_t>(clearance_.domain, 0);
  if (!first) return;
  std::vector<Cell> open = {*first};
  while (!open.empty()) {
    const Cell cell = open.back();
    open.pop_back();
    if (clearance_.get(cell) < options_.clearance_m || is_walked_[cell] != 0) continue;
    is_walked_[cell] = 1;
    for (const auto& [dx, dy] :
         {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
      open.push_back({cell.x + dx, cell.y + dy});
    }
  }
  for_each_cell(clearance_.domain, [&](const Cell& cell) {
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
                  if (clearance_.get(cell) < options_.clearance_m || is_walked_.get(cell) == 0)
                    return;
                  if (best && distance_cells(cell, middle) >= distance_cells(*best, middle)) return;
                  best = cell;
                });
  return best;
}

void WalkWays::search(const Cell& start, const std::function<bool(const Cell&, double)>& visit) {
  ++search_;
  using Entry = std::tuple<float, int, int>;  // cost, y, x: ties go by cell
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  visits_[start] = {search_, false, 0.0F, start};
  queue.emplace(0.0F, start.y, start.x);
  while (!queue.empty()) {
    const auto [cost_m, y, x] = queue.top();
    queue.pop();
    const Cell cell{x, y};
    if (visits_[cell].done) continue;
    visits_[cell].done = true;
    if (!visit(cell, cost_m)) return;
    for_each_cell({{x - 1, y - 1}, {x + 2, y + 2}}, [&, cost = cost_m](const Cell& next) {
      if (is_walked_.get(next) == 0) return;
      const double step_m = frame_.cell_m * distance_cells(next, cell);
      const float price = clearance_[next] < options_.easy_m ? kTightPrice : 1.0F;
      const float there_m = cost + price * static_cast<float>(step_m);
      Visit& there = visits_[next];
      if (there.search == search_ && (there.done || there.cost_m <= there_m)) return;
      there = {search_, false, there_m, cell};
      queue.emplace(there_m, next.y, next.x);
    });
  }
}

Polyline WalkWays::way_to(Cell cell, const Cell& start) const {
  Polyline way = {frame_.center_of(cell)};
  while (cell != start) {
    cell = visits_[cell].from;
    way.push_back(frame_.center_of(cell));
  }
  std::reverse(way.begin(), way.end());
  return way;
}

Polyline WalkWays::way_from(const Point2& from, double length_m, double share) {
  const auto start = cell_near(from);
  if (!start) return {};
  std::vector<Cell> near;
  std::vector<Cell> far;
  search(*start, [&](const Cell& cell, double cost_m) {
    (cost_m < kFarShare * length_m ? near : far).push_back(cell);
    return cost_m <= length_m;
  });
  const std::vector<Cell>& ends = far.empty() ? near : far;
  return way_to(ends[static_cast<std::size_t>(share * static_cast<double>(ends.size()))], *start);
}

Polyline WalkWays::way_to_nearest(const Point2& from,
                                  const std::function<bool(const Point2&)>& is_goal) {
  const auto start = cell_near(from);
  if (!start) return {};
  std::optional<Cell> goal;
  search(*start, [&](const Cell& cell, double) {
    if (is_goal(frame_.center_of(cell))) goal = cell;
    return !goal;
  });
  return goal ? straightened(way_to(*goal, *start)) : Polyline{};
}

/// The least on the straight line, of the cells that it passes; 0 where it leaves the floor.
double WalkWays::clearance_between(const Point2& from, const Point2& to) const {
  const double length_m = (to - from).norm();
  const int steps = static_cast<int>(std::ceil(2.0 * length_m / frame_.cell_m));
  double least_m = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i) {
    const Point2 at = from + (steps == 0 ? 0.0 : static_cast<double>(i) / steps) * (to - from);
    least_m = std::min<double>(least_m, is_walked(at) ? clearance_.get(frame_.cell_of(at)) : 0.0);
  }
  return least_m;
}

/// Corners are cut where that does not lead nearer to walls than the way itself does.
Polyline WalkWays::straightened(const Polyline& way) const {
  Polyline corners = {way.front()};
  for (std::size_t from = 0; from + 1 < way.size();) {
    std::size_t to = from + 1;
    double least_m = clearance_between(way[from], way[to]);
    double way_m = least_m;
    for (std::size_t next = to + 1; next < std::min(way.size(), from + kLongestCut); ++next) {
      way_m = std::min(way_m, clearance_between(way[next - 1], way[next]));
      least_m = clearance_between(way[from], way[next]);
      if (least_m > 0.0 && least_m >= std::min(options_.easy_m, way_m)) to = next;
    }
    corners.push_back(way[to]);
    from = to;
  }
  return corners;
}

std::vector<Point2> WalkWays::places() const {
  std::vector<Point2> places;
  for (const Cell& cell : cells_) places.push_back(frame_.center_of(cell));
  return places;
}

}  // namespace roomatlas
