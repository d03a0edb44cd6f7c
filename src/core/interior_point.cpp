// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <queue>

#include "roomatlas/core/clearance.hpp"

namespace roomatlas {
namespace {

constexpr int kMaxCells = 20'000;  // ends the search in shapes of kilometres that are metres wide
constexpr std::size_t kMaxTold = 100'000'000;  // distances to edges: the same for shapes of many

/// A square of the search, with the best clearance that any point in it could have.
struct SearchCell {
  Point2 center;
  double half_m = 0.0;
  double clearance_m = 0.0;
  double bound_m = 0.0;

  SearchCell(const Clearance& clearance, const Point2& at, double half)
      : center(at),
        half_m(half),
        clearance_m(clearance.at(at)),
        bound_m(clearance_m + half * std::sqrt(2.0)) {}
  bool operator<(const SearchCell& other) const { return bound_m < other.bound_m; }
};

/// Of a shape that no building has, with more than 5,000 edges, fewer cells are tried.
int most_cells(const Polygon& polygon) {
  std::size_t edges = polygon.outer.size();
  for (const Ring& hole : polygon.holes) edges += hole.size();
  return static_cast<int>(std::min<std::size_t>(kMaxCells, kMaxTold / edges));
}

}  // namespace

Point2 interior_point(const Polygon& polygon, double precision_m) {
  const Box2 box = bounds(polygon.outer);
  if (box.empty()) return Point2::Zero();
  const double half = box.size().maxCoeff() / 2.0;
  const Clearance clearance(polygon);
  SearchCell best(clearance, (box.min + box.max) / 2.0, 0.0);
  std::priority_queue<SearchCell> queue;
  queue.emplace(clearance, best.center, half);
  const int most = most_cells(polygon);
  for (int tried = 0; tried < most && !queue.empty(); ++tried) {
    const SearchCell cell = queue.top();
    queue.pop();
    if (cell.clearance_m > best.clearance_m) best = cell;
    if (cell.bound_m - best.clearance_m <= precision_m) continue;
    const double quarter = cell.half_m / 2.0;
    for (const double dx : {-quarter, quarter}) {
      for (const double dy : {-quarter, quarter}) {
        queue.emplace(clearance, cell.center + Point2(dx, dy), quarter);
      }
    }
  }
  return best.center;
}

}  // namespace roomatlas
