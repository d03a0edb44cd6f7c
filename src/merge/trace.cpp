// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar_map.hpp"

#include <algorithm>

namespace roomatlas::planar {
namespace {

using VertexLoop = std::vector<int>;

/// Polygons are traced face by face: faces of a group that hang together by edges make one.
class Tracer {
 public:
  Tracer(const PlaneGraph& graph, const std::vector<int>& group)
      : graph_(graph),
        group_(group),
        is_traced_(static_cast<std::size_t>(graph.half_edge_count()), 0),
        place_(static_cast<std::size_t>(graph.point_count()), 0) {}

  std::vector<std::vector<Polygon>> polygons(int groups);

 private:
  [[nodiscard]] int group(int half_edge) const {
    return group_[static_cast<std::size_t>(graph_.face(half_edge))];
  }
  [[nodiscard]] bool is_boundary(int half_edge) const {
    return group(half_edge) != group(PlaneGraph::twin(half_edge));
  }
  [[nodiscard]] bool is_traced(int half_edge) const {
    return is_traced_[static_cast<std::size_t>(half_edge)] != 0;
  }
  [[nodiscard]] int next_on_boundary(int half_edge) const;
  void trace_loop(int first);
  void add_ring(std::size_t begin, Polygon& polygon);
  void add_rings_of_loop(Polygon& polygon);
  void collect_faces(int seed, std::vector<char>& seen);
  [[nodiscard]] Polygon polygon_of_faces();

  const PlaneGraph& graph_;
  const std::vector<int>& group_;
  std::vector<char> is_traced_;
  std::vector<int> place_;  ///< of each point in `open_`, plus one; 0: not there
  std::vector<int> faces_;  ///< of the polygon at hand
  VertexLoop loop_;
  VertexLoop open_;
};

/// The boundary edge that follows: turn about the end, through faces of the group only.
int Tracer::next_on_boundary(int half_edge) const {
  int next = graph_.next(half_edge);
  while (!is_boundary(next)) next = graph_.next(PlaneGraph::twin(next));
  return next;
}

void Tracer::trace_loop(int first) {
  loop_.clear();
  for (int h = first; !is_traced(h); h = next_on_boundary(h)) {
    is_traced_[static_cast<std::size_t>(h)] = 1;
    loop_.push_back(graph_.origin(h));
  }
}

bool is_larger(const Ring& a, const Ring& b) {
  const double area_a = std::abs(signed_area(a));
  const double area_b = std::abs(signed_area(b));
  if (area_a != area_b) return area_a > area_b;
  return std::pair(a.front().x(), a.front().y()) < std::pair(b.front().x(), b.front().y());
}

/// Makes a ring of what is open from `begin` on: from its lowest vertex, so that the same ring is
/// always written alike. The ring that runs counter-clockwise is the polygon's outside.
void Tracer::add_ring(std::size_t begin, Polygon& polygon) {
  for (std::size_t i = begin; i < open_.size(); ++i) place_[static_cast<std::size_t>(open_[i])] = 0;
  if (open_.size() - begin >= 3) {
    Ring ring;
    ring.reserve(open_.size() - begin);
    for (std::size_t i = begin; i < open_.size(); ++i) ring.push_back(graph_.point(open_[i]));
    const auto lowest =
        std::min_element(ring.begin(), ring.end(), [](const auto& a, const auto& b) {
          return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
        });
    std::rotate(ring.begin(), lowest, ring.end());
    if (signed_area(ring) > 0.0 && (polygon.outer.empty() || is_larger(ring, polygon.outer))) {
      polygon.outer = std::move(ring);
    } else {
      polygon.holes.push_back(std::move(ring));
    }
  }
  open_.resize(begin);
}

/// Cuts the loop into rings that pass no vertex twice.
void Tracer::add_rings_of_loop(Polygon& polygon) {
  for (const int vertex : loop_) {
    const int before = place_[static_cast<std::size_t>(vertex)];
    if (before > 0) add_ring(static_cast<std::size_t>(before) - 1, polygon);
    open_.push_back(vertex);
    place_[static_cast<std::size_t>(vertex)] = static_cast<int>(open_.size());
  }
  add_ring(0, polygon);
}

/// Of faces that hang together exactly one ring runs counter-clockwise: their outside.
Polygon Tracer::polygon_of_faces() {
  Polygon polygon;
  for (const int face : faces_) {
    for (const int start : graph_.loops_of(face)) {
      int h = start;
      do {
        if (is_boundary(h) && !is_traced(h)) {
          trace_loop(h);
          add_rings_of_loop(polygon);
        }
        h = graph_.next(h);
      } while (h != start);
    }
  }
  std::sort(polygon.holes.begin(), polygon.holes.end(), is_larger);
  return polygon;
}

void Tracer::collect_faces(int seed, std::vector<char>& seen) {
  faces_ = {seed};
  seen[static_cast<std::size_t>(seed)] = 1;
  for (std::size_t at = 0; at < faces_.size(); ++at) {
    for (const int start : graph_.loops_of(faces_[at])) {
      int h = start;
      do {
        const int next = graph_.face(PlaneGraph::twin(h));
        if (!is_boundary(h) && seen[static_cast<std::size_t>(next)] == 0) {
          faces_.push_back(next);
          seen[static_cast<std::size_t>(next)] = 1;
        }
        h = graph_.next(h);
      } while (h != start);
    }
  }
}

std::vector<std::vector<Polygon>> Tracer::polygons(int groups) {
  std::vector<std::vector<Polygon>> found(static_cast<std::size_t>(groups));
  std::vector<char> seen(static_cast<std::size_t>(graph_.face_count()), 0);
  for (int face = 0; face < graph_.face_count(); ++face) {
    const int group = group_[static_cast<std::size_t>(face)];
    if (group < 0 || seen[static_cast<std::size_t>(face)] != 0) continue;
    collect_faces(face, seen);
    Polygon polygon = polygon_of_faces();
    if (!polygon.outer.empty())
      found[static_cast<std::size_t>(group)].push_back(std::move(polygon));
  }
  for (auto& polygons : found) {
    std::sort(polygons.begin(), polygons.end(),
              [](const Polygon& a, const Polygon& b) { return is_larger(a.outer, b.outer); });
  }
  return found;
}

}  // namespace

std::vector<std::vector<Polygon>> trace_boundaries(const PlaneGraph& graph,
                                                   const std::vector<int>& group_of_face,
                                                   int groups) {
  return Tracer(graph, group_of_face).polygons(groups);
}

}  // namespace roomatlas::planar
