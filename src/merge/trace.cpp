// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar_map.hpp"

#include <algorithm>

namespace roomatlas::planar {
namespace {

/// An edge of a triangle, named by the triangle and its number there.
struct EdgeRef {
  std::size_t triangle = 0;
  std::size_t edge = 0;
};

using VertexLoop = std::vector<int>;

class Tracer {
 public:
  Tracer(const TriangleMesh& mesh, const std::vector<int>& group)
      : mesh_(mesh), group_(group), is_traced_(mesh.triangles.size() * 3, false) {}

  std::vector<std::vector<Polygon>> polygons(int groups);

 private:
  [[nodiscard]] const Triangle& triangle(std::size_t t) const { return mesh_.triangles[t]; }
  [[nodiscard]] int start_of(const EdgeRef& e) const {
    return triangle(e.triangle).corner[(e.edge + 1) % 3];
  }
  [[nodiscard]] bool is_boundary(const EdgeRef& e) const {
    const int beyond = triangle(e.triangle).neighbor[e.edge];
    return beyond < 0 || group_[static_cast<std::size_t>(beyond)] != group_[e.triangle];
  }
  [[nodiscard]] EdgeRef next_boundary_edge(EdgeRef e) const;
  [[nodiscard]] VertexLoop loop_from(EdgeRef first);
  [[nodiscard]] Polygon polygon_of(const std::vector<std::size_t>& component);
  [[nodiscard]] std::vector<std::size_t> component_from(std::size_t seed,
                                                        std::vector<bool>& seen) const;

  const TriangleMesh& mesh_;
  const std::vector<int>& group_;
  std::vector<bool> is_traced_;  ///< three an edge's triangle
};

/// The boundary edge that follows: turn about the end of `e`, through triangles of its group only.
EdgeRef Tracer::next_boundary_edge(EdgeRef e) const {
  EdgeRef next{e.triangle, (e.edge + 1) % 3};
  while (!is_boundary(next)) {
    const auto beyond = static_cast<std::size_t>(triangle(next.triangle).neighbor[next.edge]);
    std::size_t back = 0;
    while (triangle(beyond).neighbor[back] != static_cast<int>(next.triangle)) ++back;
    next = {beyond, (back + 1) % 3};
  }
  return next;
}

VertexLoop Tracer::loop_from(EdgeRef first) {
  VertexLoop loop;
  for (EdgeRef e = first; !is_traced_[e.triangle * 3 + e.edge]; e = next_boundary_edge(e)) {
    is_traced_[e.triangle * 3 + e.edge] = true;
    loop.push_back(start_of(e));
  }
  return loop;
}

/// Cuts a loop that passes a vertex twice into loops that do not.
std::vector<VertexLoop> split_at_repeated(const VertexLoop& loop) {
  std::vector<VertexLoop> loops;
  VertexLoop open;
  std::vector<int> sorted = loop;
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::size_t> position(sorted.size(), 0);  // in `open`, plus one
  const auto slot = [&](int vertex) -> std::size_t& {
    const auto it = std::lower_bound(sorted.begin(), sorted.end(), vertex);
    return position[static_cast<std::size_t>(it - sorted.begin())];
  };
  for (const int vertex : loop) {
    if (const std::size_t before = slot(vertex); before > 0) {
      loops.emplace_back(open.begin() + static_cast<std::ptrdiff_t>(before - 1), open.end());
      for (const int closed : loops.back()) slot(closed) = 0;
      open.resize(before - 1);
    }
    open.push_back(vertex);
    slot(vertex) = open.size();
  }
  loops.push_back(open);
  return loops;
}

/// The ring of a loop, from its lowest vertex on, so that the same ring is always written alike.
Ring ring_of(const TriangleMesh& mesh, const VertexLoop& loop) {
  Ring ring;
  ring.reserve(loop.size());
  for (const int vertex : loop) ring.push_back(mesh.points_mm[static_cast<std::size_t>(vertex)]);
  const auto lowest = std::min_element(ring.begin(), ring.end(), [](const auto& a, const auto& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  });
  std::rotate(ring.begin(), lowest, ring.end());
  return ring;
}

bool is_larger(const Ring& a, const Ring& b) {
  const double area_a = std::abs(signed_area(a));
  const double area_b = std::abs(signed_area(b));
  if (area_a != area_b) return area_a > area_b;
  return std::pair(a.front().x(), a.front().y()) < std::pair(b.front().x(), b.front().y());
}

/// Of an edge-connected component exactly one loop is counter-clockwise: its outside.
Polygon Tracer::polygon_of(const std::vector<std::size_t>& component) {
  Polygon polygon;
  for (const std::size_t t : component) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!is_boundary({t, i}) || is_traced_[t * 3 + i]) continue;
      for (const VertexLoop& loop : split_at_repeated(loop_from({t, i}))) {
        if (loop.size() < 3) continue;
        Ring ring = ring_of(mesh_, loop);
        if (signed_area(ring) > 0.0 && (polygon.outer.empty() || is_larger(ring, polygon.outer))) {
          polygon.outer = std::move(ring);
        } else {
          polygon.holes.push_back(std::move(ring));
        }
      }
    }
  }
  std::sort(polygon.holes.begin(), polygon.holes.end(), is_larger);
  return polygon;
}

std::vector<std::size_t> Tracer::component_from(std::size_t seed, std::vector<bool>& seen) const {
  std::vector<std::size_t> component = {seed};
  seen[seed] = true;
  for (std::size_t at = 0; at < component.size(); ++at) {
    const std::size_t t = component[at];
    for (std::size_t i = 0; i < 3; ++i) {
      if (is_boundary({t, i})) continue;
      const auto next = static_cast<std::size_t>(triangle(t).neighbor[i]);
      if (!seen[next]) component.push_back(next);
      seen[next] = true;
    }
  }
  return component;
}

std::vector<std::vector<Polygon>> Tracer::polygons(int groups) {
  std::vector<std::vector<Polygon>> found(static_cast<std::size_t>(groups));
  std::vector<bool> seen(mesh_.triangles.size(), false);
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (group_[t] < 0 || seen[t]) continue;
    Polygon polygon = polygon_of(component_from(t, seen));
    if (polygon.outer.empty()) continue;
    found[static_cast<std::size_t>(group_[t])].push_back(std::move(polygon));
  }
  for (auto& polygons : found) {
    std::sort(polygons.begin(), polygons.end(),
              [](const Polygon& a, const Polygon& b) { return is_larger(a.outer, b.outer); });
  }
  return found;
}

}  // namespace

std::vector<std::vector<Polygon>> trace_boundaries(const TriangleMesh& mesh,
                                                   const std::vector<int>& group_of_triangle,
                                                   int groups) {
  return Tracer(mesh, group_of_triangle).polygons(groups);
}

}  // namespace roomatlas::planar
