// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/planar/plane_graph.hpp"

#include "below.hpp"
#include "predicates.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace roomatlas::planar {
namespace {

/// Prefix sums in place: counts become where each begins; one more than there are counts.
void to_offsets(std::vector<int>& counts) {
  int sum = 0;
  for (int& count : counts) {
    const int here = count;
    count = sum;
    sum += here;
  }
}

/// Whether the direction points into the half circle that begins with the x axis.
bool is_upper(const Point2& direction) {
  return direction.y() > 0.0 || (direction.y() == 0.0 && direction.x() > 0.0);
}

/// Disjoint sets.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int find(int element) {
    while (parent(element) != element) {
      parent(element) = parent(parent(element));
      element = parent(element);
    }
    return element;
  }
  void unite(int a, int b) {
    a = find(a);
    b = find(b);
    parent(std::max(a, b)) = std::min(a, b);
  }

 private:
  int& parent(int element) { return parent_[static_cast<std::size_t>(element)]; }
  std::vector<int> parent_;
};

}  // namespace

PlaneGraph::PlaneGraph(EdgeSet cut) {
  points_mm_ = std::move(cut.points_mm);
  join_equal_edges(cut.edges);
  cut.edges = {};
  link_half_edges();
  find_loops();
  find_faces();
  measure_faces();
}

void PlaneGraph::join_equal_edges(const std::vector<RingEdge>& edges) {
  struct Use {
    int high;
    int ring;
    int turns;
  };
  std::vector<int> first(points_mm_.size() + 1, 0);
  for (const RingEdge& edge : edges)
    ++first[static_cast<std::size_t>(std::min(edge.from, edge.to))];
  to_offsets(first);
  std::vector<Use> by_low(edges.size());
  for (const RingEdge& edge : edges) {
    const auto low = static_cast<std::size_t>(std::min(edge.from, edge.to));
    by_low[static_cast<std::size_t>(first[low]++)] = {std::max(edge.from, edge.to), edge.ring,
                                                      edge.from < edge.to ? 1 : -1};
  }
  origin_.reserve(2 * edges.size());
  uses_.reserve(edges.size());
  std::size_t begin = 0;
  for (std::size_t low = 0; low < points_mm_.size(); ++low) {
    const auto end = static_cast<std::size_t>(first[low]);
    std::sort(by_low.begin() + static_cast<std::ptrdiff_t>(begin),
              by_low.begin() + static_cast<std::ptrdiff_t>(end), [](const Use& a, const Use& b) {
                return a.high != b.high ? a.high < b.high : a.ring < b.ring;
              });
    for (std::size_t u = begin; u < end; ++u) {
      const Use& use = by_low[u];
      const bool is_same_edge = u > begin && by_low[u - 1].high == use.high;
      if (!is_same_edge) {
        origin_.push_back(static_cast<int>(low));
        origin_.push_back(use.high);
        first_use_.push_back(static_cast<int>(uses_.size()));
      }
      if (is_same_edge && uses_.back().ring == use.ring) {
        uses_.back().turns += use.turns;
      } else {
        uses_.push_back({use.ring, use.turns});
      }
    }
    begin = end;
  }
  first_use_.push_back(static_cast<int>(uses_.size()));
}

void PlaneGraph::sort_by_angle(std::span<int> outgoing) const {
  std::sort(outgoing.begin(), outgoing.end(), [&](int a, int b) {
    const Point2& centre = point(origin(a));
    const Point2& to_a = point(origin(twin(a)));
    const Point2& to_b = point(origin(twin(b)));
    const bool upper_a = is_upper(to_a - centre);
    const bool upper_b = is_upper(to_b - centre);
    if (upper_a != upper_b) return upper_a;
    return orientation(centre, to_a, to_b) > 0;
  });
}

/// At each point a loop turns as far to the left as it can: to the outgoing half-edge that comes
/// clockwise after the way back.
void PlaneGraph::link_half_edges() {
  std::vector<int> first(points_mm_.size() + 1, 0);
  for (const int from : origin_) ++first[static_cast<std::size_t>(from)];
  to_offsets(first);
  std::vector<int> outgoing(origin_.size());
  for (int h = 0; h < half_edge_count(); ++h) {
    outgoing[static_cast<std::size_t>(first[static_cast<std::size_t>(origin(h))]++)] = h;
  }
  next_.resize(origin_.size());
  std::size_t begin = 0;
  for (std::size_t p = 0; p < points_mm_.size(); ++p) {
    const auto end = static_cast<std::size_t>(first[p]);
    const std::span<int> around(outgoing.data() + begin, end - begin);
    if (around.size() > 2) sort_by_angle(around);
    for (std::size_t i = 0; i < around.size(); ++i) {
      const int clockwise = around[(i + around.size() - 1) % around.size()];
      next_[static_cast<std::size_t>(twin(around[i]))] = clockwise;
    }
    begin = end;
  }
}

void PlaneGraph::find_loops() {
  loop_.assign(origin_.size(), -1);
  for (int seed = 0; seed < half_edge_count(); ++seed) {
    if (at(loop_, seed) >= 0) continue;
    const int id = static_cast<int>(start_.size());
    start_.push_back(seed);
    for (int h = seed; at(loop_, h) < 0; h = next(h)) loop_[static_cast<std::size_t>(h)] = id;
  }
}

/// The loop around the outside of each connected part, by height of the part's lowest point. There
/// the half-edge with the least angle has the outside on its right.
std::vector<int> PlaneGraph::outer_loops() const {
  Sets parts(start_.size());
  for (int h = 0; h < half_edge_count(); h += 2) parts.unite(at(loop_, h), at(loop_, h + 1));
  std::vector<int> lowest(start_.size(), -1);  // half-edge of each part from its lowest point
  const auto is_before = [&](int a, int b) {
    const Point2& p = point(origin(a));
    const Point2& q = point(origin(b));
    if (p.y() != q.y()) return p.y() < q.y();
    if (p.x() != q.x()) return p.x() < q.x();
    return orientation(p, point(origin(twin(a))), point(origin(twin(b)))) > 0;
  };
  for (int h = 0; h < half_edge_count(); ++h) {
    int& best = lowest[static_cast<std::size_t>(parts.find(at(loop_, h)))];
    if (best < 0 || is_before(h, best)) best = h;
  }
  std::erase(lowest, -1);
  std::sort(lowest.begin(), lowest.end(), is_before);
  for (int& half_edge : lowest) half_edge = twin(half_edge);
  return lowest;
}

/// Every loop is the outside of a face, but for those around connected parts: these belong to the
/// face that the part lies in, which is found below its lowest point.
void PlaneGraph::find_faces() {
  const std::vector<int> outer = outer_loops();
  face_of_loop_.assign(start_.size(), -1);
  for (const int half_edge : outer)
    face_of_loop_[static_cast<std::size_t>(at(loop_, half_edge))] = -2;
  for (int& face : face_of_loop_) {
    if (face == -1) face = face_count_++;
  }
  if (outer.size() == 1) {
    face_of_loop_[static_cast<std::size_t>(at(loop_, outer.front()))] = kOutside;
    return;
  }
  const EdgeBelow below(points_mm_, origin_);
  for (const int half_edge : outer) {  // from the lowest up, so that what lies below has its face
    const int found = below.half_edge_below(point(origin(twin(half_edge))));
    face_of_loop_[static_cast<std::size_t>(at(loop_, half_edge))] =
        found < 0 ? kOutside : face(found);
  }
}

void PlaneGraph::measure_faces() {
  area_mm2_.assign(static_cast<std::size_t>(face_count_), 0.0);
  first_loop_.assign(static_cast<std::size_t>(face_count_) + 1, 0);
  for (std::size_t loop = 0; loop < start_.size(); ++loop) {
    const int start = start_[loop];
    const Point2 base = point(origin(start));  // near the loop, so that areas keep their precision
    double doubled = 0.0;
    int h = start;
    do {
      doubled += cross(point(origin(h)) - base, point(origin(twin(h))) - base);
      h = next(h);
    } while (h != start);
    const auto of = static_cast<std::size_t>(face_of_loop_[loop]);
    area_mm2_[of] += doubled / 2.0;
    ++first_loop_[of];
  }
  area_mm2_[kOutside] = 0.0;
  to_offsets(first_loop_);
  loop_starts_.resize(start_.size());
  std::vector<int> place = first_loop_;
  for (std::size_t loop = 0; loop < start_.size(); ++loop) {
    const auto of = static_cast<std::size_t>(face_of_loop_[loop]);
    loop_starts_[static_cast<std::size_t>(place[of]++)] = start_[loop];
  }
}

}  // namespace roomatlas::planar
