// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/planar/planar_map.hpp"

#include <algorithm>

namespace roomatlas::planar {
namespace {

using VertexLoop = std::vector<int>;

constexpr double kStraightTolerance_mm = 3e-5;  // of crossings on the fine grid

/// Whether `b` lies between `a` and `c`, within the tolerance.
bool is_straight(const Point2& a, const Point2& b, const Point2& c) {
  const Point2 whole = c - a;
  if ((b - a).dot(c - b) < 0.0) return false;
  const double doubled = cross(whole, b - a);
  return doubled * doubled <= kStraightTolerance_mm * kStraightTolerance_mm * whole.squaredNorm();
}

/// A ring and its signed area.
struct TracedRing {
  Ring ring;
  double area_mm2 = 0.0;
};

/// A polygon's rings as they are found.
struct TracedPolygon {
  TracedRing outer;
  std::vector<TracedRing> holes;
};

/// Polygons are traced face by face: faces of a group that hang together by edges make one.
class Tracer {
 public:
  Tracer(const PlaneGraph& graph, const std::vector<int>& group)
      : graph_(graph),
        group_(group),
        is_traced_(static_cast<std::size_t>(graph.half_edge_count()), 0),
        place_(static_cast<std::size_t>(graph.point_count()), 0),
        borders_at_(static_cast<std::size_t>(graph.point_count()), 0) {
    for (int h = 0; h < graph.half_edge_count(); ++h) {
      if (is_boundary(h)) ++borders_at_[static_cast<std::size_t>(graph.origin(h))];
    }
  }

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
  /// Whether the vertex may be left out: it lies on the straight line between the others, and no
  /// other border meets there, which would then end on an edge.
  [[nodiscard]] bool is_needless(int before, int vertex, int after) const {
    return borders_at_[static_cast<std::size_t>(vertex)] == 2 &&
           is_straight(graph_.point(before), graph_.point(vertex), graph_.point(after));
  }
  [[nodiscard]] int next_on_boundary(int half_edge) const;
  void leave_out_needless(VertexLoop& vertices) const;
  void trace_loop(int first);
  void add_ring(std::size_t begin, TracedPolygon& polygon);
  void add_rings_of_loop(TracedPolygon& polygon);
  void collect_faces(int seed, std::vector<char>& seen);
  [[nodiscard]] TracedPolygon polygon_of_faces();

  const PlaneGraph& graph_;
  const std::vector<int>& group_;
  std::vector<char> is_traced_;
  std::vector<int> place_;       ///< of each point in `open_`, plus one; 0: not there
  std::vector<int> borders_at_;  ///< boundary edges at each point
  std::vector<int> faces_;       ///< of the polygon at hand
  VertexLoop loop_;
  VertexLoop open_;
  VertexLoop ring_;
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

void Tracer::leave_out_needless(VertexLoop& vertices) const {
  std::size_t kept = 0;
  for (const int vertex : vertices) {
    while (kept >= 2 && is_needless(vertices[kept - 2], vertices[kept - 1], vertex)) --kept;
    vertices[kept++] = vertex;
  }
  while (kept > 3 && is_needless(vertices[kept - 2], vertices[kept - 1], vertices[0])) --kept;
  std::size_t begin = 0;
  while (kept - begin > 3 &&
         is_needless(vertices[kept - 1], vertices[begin], vertices[begin + 1])) {
    ++begin;
  }
  vertices.resize(kept);
  vertices.erase(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(begin));
}

/// Larger areas first, whichever way the rings run.
bool is_larger(const TracedRing& a, const TracedRing& b) {
  const double area_a = std::abs(a.area_mm2);
  const double area_b = std::abs(b.area_mm2);
  if (area_a != area_b) return area_a > area_b;
  const Point2& p = a.ring.front();
  const Point2& q = b.ring.front();
  return std::pair(p.x(), p.y()) < std::pair(q.x(), q.y());
}

/// Makes a ring of what is open from `begin` on: from its lowest vertex, so that the same ring is
/// always written alike. The ring that runs counter-clockwise is the polygon's outside.
void Tracer::add_ring(std::size_t begin, TracedPolygon& polygon) {
  for (std::size_t i = begin; i < open_.size(); ++i) place_[static_cast<std::size_t>(open_[i])] = 0;
  if (open_.size() - begin >= 3) {
    Ring ring;
    ring_.assign(open_.begin() + static_cast<std::ptrdiff_t>(begin), open_.end());
    leave_out_needless(ring_);
    ring.reserve(ring_.size());
    for (const int vertex : ring_) ring.push_back(graph_.point(vertex));
    const auto lowest =
        std::min_element(ring.begin(), ring.end(), [](const auto& a, const auto& b) {
          return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
        });
    std::rotate(ring.begin(), lowest, ring.end());
    const double area_mm2 = signed_area(ring);
    TracedRing traced{std::move(ring), area_mm2};
    const bool is_first = polygon.outer.ring.empty();
    if (area_mm2 > 0.0 && (is_first || is_larger(traced, polygon.outer))) {
      polygon.outer = std::move(traced);
    } else {
      polygon.holes.push_back(std::move(traced));
    }
  }
  open_.resize(begin);
}

/// Cuts the loop into rings that pass no vertex twice.
void Tracer::add_rings_of_loop(TracedPolygon& polygon) {
  for (const int vertex : loop_) {
    const int before = place_[static_cast<std::size_t>(vertex)];
    if (before > 0) add_ring(static_cast<std::size_t>(before) - 1, polygon);
    open_.push_back(vertex);
    place_[static_cast<std::size_t>(vertex)] = static_cast<int>(open_.size());
  }
  add_ring(0, polygon);
}

/// Of faces that hang together exactly one ring runs counter-clockwise: their outside.
TracedPolygon Tracer::polygon_of_faces() {
  TracedPolygon polygon;
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
  std::vector<std::vector<TracedPolygon>> found(static_cast<std::size_t>(groups));
  std::vector<char> seen(static_cast<std::size_t>(graph_.face_count()), 0);
  for (int face = 0; face < graph_.face_count(); ++face) {
    const int group = group_[static_cast<std::size_t>(face)];
    if (group < 0 || seen[static_cast<std::size_t>(face)] != 0) continue;
    collect_faces(face, seen);
    TracedPolygon polygon = polygon_of_faces();
    if (polygon.outer.ring.empty()) continue;
    found[static_cast<std::size_t>(group)].push_back(std::move(polygon));
  }
  std::vector<std::vector<Polygon>> polygons(found.size());
  for (std::size_t group = 0; group < found.size(); ++group) {
    std::sort(found[group].begin(), found[group].end(),
              [](const auto& a, const auto& b) { return is_larger(a.outer, b.outer); });
    for (TracedPolygon& traced : found[group]) {
      polygons[group].push_back({std::move(traced.outer.ring), {}});
      auto& holes = polygons[group].back().holes;
      for (TracedRing& hole : traced.holes) holes.push_back(std::move(hole.ring));
    }
  }
  return polygons;
}

}  // namespace

std::vector<std::vector<Polygon>> trace_boundaries(const PlaneGraph& graph,
                                                   const std::vector<int>& group_of_face,
                                                   int groups) {
  return Tracer(graph, group_of_face).polygons(groups);
}

}  // namespace roomatlas::planar
