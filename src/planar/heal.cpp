// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/planar/heal.hpp"

#include "predicates.hpp"
#include "roomatlas/planar/planar_map.hpp"

#include <algorithm>

namespace roomatlas::planar {
namespace {

/// An edge, running from left to right, and its place in the polygon.
struct Edge {
  Point2 left;
  Point2 right;
  std::size_t ring = 0;
  std::size_t index = 0;  ///< in the ring; the edge ends in the vertex of that index plus one
  std::size_t count = 0;  ///< edges of the ring

  [[nodiscard]] double low() const { return std::min(left.y(), right.y()); }
  [[nodiscard]] double high() const { return std::max(left.y(), right.y()); }
};

void add_edges(const Ring& ring, std::size_t id, std::vector<Edge>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    Edge edge{ring[i], ring[(i + 1) % ring.size()], id, i, ring.size()};
    if (edge.right.x() < edge.left.x()) std::swap(edge.left, edge.right);
    edges.push_back(edge);
  }
}

/// Neighbours in a ring meet in their common vertex and, where the ring runs back on itself, in
/// more.
bool is_spike(const Edge& a, const Edge& b) {
  const bool shares_left_of_a = a.left == b.left || a.left == b.right;
  const Point2& shared = shares_left_of_a ? a.left : a.right;
  const Point2& end_a = shares_left_of_a ? a.right : a.left;
  const Point2& end_b = shared == b.left ? b.right : b.left;
  return orientation(shared, end_a, end_b) == 0 && (end_a - shared).dot(end_b - shared) > 0.0;
}

bool meet(const Edge& a, const Edge& b) {
  if (a.ring == b.ring) {
    const std::size_t apart = a.index > b.index ? a.index - b.index : b.index - a.index;
    if (apart == 1 || apart + 1 == a.count) return is_spike(a, b);
  }
  return orientation(a.left, a.right, b.left) * orientation(a.left, a.right, b.right) <= 0 &&
         orientation(b.left, b.right, a.left) * orientation(b.left, b.right, a.right) <= 0;
}

void run_counter_clockwise(Ring& ring, bool counter_clockwise) {
  if ((signed_area(ring) > 0.0) != counter_clockwise) std::reverse(ring.begin(), ring.end());
}

}  // namespace

bool is_simple(const Polygon& polygon_mm) {
  std::vector<Edge> edges;
  add_edges(polygon_mm.outer, 0, edges);
  for (std::size_t h = 0; h < polygon_mm.holes.size(); ++h) {
    add_edges(polygon_mm.holes[h], h + 1, edges);
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.left.x() < b.left.x(); });
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size() && edges[j].left.x() <= edges[i].right.x(); ++j) {
      if (edges[i].low() > edges[j].high() || edges[j].low() > edges[i].high()) continue;
      if (meet(edges[i], edges[j])) return false;
    }
  }
  return true;
}

std::vector<Polygon> healed(const Polygon& polygon_mm, double fine) {
  if (polygon_mm.outer.size() < 3) return {};
  Polygon whole{polygon_mm.outer, {}};
  for (const Ring& hole : polygon_mm.holes) {
    if (hole.size() >= 3) whole.holes.push_back(hole);
  }
  if (is_simple(whole)) {
    run_counter_clockwise(whole.outer, true);
    for (Ring& hole : whole.holes) run_counter_clockwise(hole, false);
    return {std::move(whole)};
  }
  const PlanarMap map({whole}, fine);
  std::vector<int> group;
  for (int region = 0; region < map.region_count(); ++region) {
    group.push_back(map.covering(region).empty() ? -1 : 0);
  }
  return map.trace(group, 1).front();
}

}  // namespace roomatlas::planar
