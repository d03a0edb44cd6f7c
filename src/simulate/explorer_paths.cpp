// SPDX-License-Identifier: GPL-3.0-or-later
#include "explorer_paths.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>
#include <tuple>

namespace roomatlas {
namespace {

constexpr double kStartFreedomM = 0.35;    // how far the robot may go to where it may be
constexpr float kImpassablePrice = 20.0F;  // a metre there costs so many: out of it by the shortest
constexpr float kTightPrice = 8.0F;        // where it cannot turn; less lets it scrape along walls

}  // namespace

Pose2 pose_on_way(const Polyline& way, std::size_t i) {
  constexpr std::size_t kReach = 5;  // points each way; fewer follow the raster's steps
  const Point2& from = way[i - std::min(i, kReach)];
  const Point2& to = way[std::min(i + kReach, way.size() - 1)];
  return {way[i].x(), way[i].y(), std::atan2(to.y() - from.y(), to.x() - from.x())};
}

Point2 a_metre_before(const Pose2& map_from_way) { return map_from_way * Point2(-1.0, 0.0); }

void PathFinder::follow(const CellBox& box) {
  if (box.min == box_.min && box.max == box_.max) return;
  box_ = box;
  visits_.assign(box.count(), {});
  search_ = 0;
}

bool PathFinder::reached(const Cell& cell) const {
  if (!box_.contains(cell)) return false;
  const Visit& visit = visits_[box_.index_of(cell)];
  return visit.search == search_ && visit.done;
}

std::optional<Polyline> PathFinder::way(const ExplorerMap& map, const Point2& start,
                                        const CellTest& is_goal, const CellTest& is_closed) {
  follow(map.box());
  ++search_;
  const CellFrame& frame = map.frame();
  const Cell start_cell = frame.cell_of(start);
  using Entry = std::tuple<float, int, int>;  // cost, y, x: ties go by cell
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto open = [&](const Cell& cell, float cost_m, const Cell& from) {
    Visit& visit = visits_[box_.index_of(cell)];
    if (visit.search == search_ && (visit.done || visit.cost_m <= cost_m)) return;
    visit = {search_, false, cost_m, from};
    queue.emplace(cost_m, cell.y, cell.x);
  };
  const auto price = [&](const Cell& cell) {
    if (map.is_passable(cell)) return map.is_tight(cell) ? kTightPrice : 1.0F;
    const bool beside = (frame.center_of(cell) - start).norm() <= kStartFreedomM;
    return beside && !map.is_obstacle(cell) ? kImpassablePrice : 0.0F;
  };
  if (!box_.contains(start_cell)) return std::nullopt;
  open(start_cell, 0.0F, start_cell);
  while (!queue.empty()) {
    const auto [cost_m, y, x] = queue.top();
    queue.pop();
    const Cell cell{x, y};
    Visit& visit = visits_[box_.index_of(cell)];
    if (visit.done) continue;
    visit.done = true;
    if (is_goal(cell)) {
      Polyline way = {frame.center_of(cell)};
      for (Cell at = cell; at != start_cell;) {
        at = visits_[box_.index_of(at)].from;
        way.push_back(frame.center_of(at));
      }
      std::reverse(way.begin(), way.end());
      return way;
    }
    for_each_cell({{x - 1, y - 1}, {x + 2, y + 2}}, [&, cost = cost_m](const Cell& next) {
      if (next == cell || !box_.contains(next) || reached(next)) return;
      const float share = price(next);
      if (share == 0.0F || is_closed(next)) return;
      const bool is_straight = next.x == cell.x || next.y == cell.y;
      const double step_m = frame.cell_m * (is_straight ? 1.0 : std::numbers::sqrt2);
      open(next, cost + share * static_cast<float>(step_m), cell);
    });
  }
  return std::nullopt;
}

}  // namespace roomatlas
