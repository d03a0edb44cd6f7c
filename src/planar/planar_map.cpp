// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/planar/planar_map.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas::planar {
namespace {

/// Appends a ring's edges.
void add_ring(const Ring& ring, int id, PointNumbers& numbers, EdgeSet& set) {
  int first = -1;
  int previous = -1;
  for (const Point2& point : ring) {
    const int current = numbers.number_of(on_fine_grid(point, set.fine));
    if (previous < 0) {
      first = current;
    } else if (current != previous) {
      set.edges.push_back({previous, current, id});
    }
    previous = current;
  }
  if (previous != first) set.edges.push_back({previous, first, id});
}

/// The edges of all rings, which are numbered in the order of the shapes.
EdgeSet edges_of(const std::vector<Polygon>& shapes, double fine, std::vector<int>& shape_of_ring) {
  std::size_t vertices = 0;
  for (const Polygon& shape : shapes) {
    vertices += shape.outer.size();
    for (const Ring& hole : shape.holes) vertices += hole.size();
  }
  EdgeSet set{fine, {}, {}};
  set.points_mm.reserve(vertices);
  set.edges.reserve(vertices);
  PointNumbers numbers(set.points_mm, vertices);
  const auto add = [&](const Ring& ring, std::size_t shape) {
    const int id = static_cast<int>(shape_of_ring.size());
    shape_of_ring.push_back(static_cast<int>(shape));
    if (ring.size() >= 3) add_ring(ring, id, numbers, set);
  };
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    add(shapes[s].outer, s);
    for (const Ring& hole : shapes[s].holes) add(hole, s);
  }
  return set;
}

/// How often rings wind around a region, by ring; those that do not are left out.
using Windings = std::vector<RingUse>;

/// The windings on the right of a half-edge, from those on its left: a ring has one more on its
/// left.
void cross_edge(std::span<const RingUse> uses, int direction, Windings& windings) {
  for (const RingUse& use : uses) {
    const auto at =
        std::lower_bound(windings.begin(), windings.end(), use.ring,
                         [](const RingUse& winding, int ring) { return winding.ring < ring; });
    const int change = -direction * use.turns;
    if (at == windings.end() || at->ring != use.ring) {
      if (change != 0) windings.insert(at, {use.ring, change});
    } else {
      at->turns += change;
      if (at->turns == 0) windings.erase(at);
    }
  }
}

/// The windings of every region in one list.
struct AllWindings {
  struct Place {
    std::size_t begin = 0;
    std::size_t count = 0;
  };
  std::vector<RingUse> list;
  std::vector<Place> of_face;
};

/// Spreads from the unbounded face, around which nothing winds, over the edges between faces.
AllWindings windings_of(const PlaneGraph& graph) {
  AllWindings all;
  all.of_face.resize(static_cast<std::size_t>(graph.face_count()));
  std::vector<char> is_known(all.of_face.size(), 0);
  std::vector<int> open = {PlaneGraph::kOutside};
  is_known[PlaneGraph::kOutside] = 1;
  Windings beyond;
  while (!open.empty()) {
    const int face = open.back();
    open.pop_back();
    const AllWindings::Place here = all.of_face[static_cast<std::size_t>(face)];
    for (const int start : graph.loops_of(face)) {
      int h = start;
      do {
        const auto other = static_cast<std::size_t>(graph.face(PlaneGraph::twin(h)));
        if (is_known[other] == 0) {
          is_known[other] = 1;
          open.push_back(static_cast<int>(other));
          const auto begin = all.list.begin() + static_cast<std::ptrdiff_t>(here.begin);
          beyond.assign(begin, begin + static_cast<std::ptrdiff_t>(here.count));
          cross_edge(graph.uses(h / 2), h % 2 == 0 ? 1 : -1, beyond);
          all.of_face[other] = {all.list.size(), beyond.size()};
          all.list.insert(all.list.end(), beyond.begin(), beyond.end());
        }
        h = graph.next(h);
      } while (h != start);
    }
  }
  return all;
}

}  // namespace

PlanarMap::PlanarMap(const std::vector<Polygon>& shapes_mm, double fine, int first_positive)
    : graph_(cut_where_they_meet(edges_of(shapes_mm, fine, shape_of_ring_))) {
  const int shape_count = static_cast<int>(shapes_mm.size());
  find_coverings(shape_count, first_positive < 0 ? shape_count : first_positive);
}

void PlanarMap::find_coverings(int shape_count, int first_positive) {
  const AllWindings all = windings_of(graph_);
  std::vector<int> outer_ring(static_cast<std::size_t>(shape_count), 0);
  for (std::size_t ring = shape_of_ring_.size(); ring-- > 0;) {
    outer_ring[static_cast<std::size_t>(shape_of_ring_[ring])] = static_cast<int>(ring);
  }
  first_cover_.push_back(0);
  for (const AllWindings::Place& place : all.of_face) {
    for (std::size_t i = place.begin; i < place.begin + place.count;) {
      const int shape = shape_of_ring_[static_cast<std::size_t>(all.list[i].ring)];
      const bool is_in_outer = all.list[i].ring == outer_ring[static_cast<std::size_t>(shape)];
      int rings = 0;
      int turns = 0;
      for (; i < place.begin + place.count; ++i, ++rings) {
        if (shape_of_ring_[static_cast<std::size_t>(all.list[i].ring)] != shape) break;
        turns += all.list[i].turns;
      }
      if (shape >= first_positive ? turns > 0 : is_in_outer && rings == 1) covers_.push_back(shape);
    }
    first_cover_.push_back(static_cast<int>(covers_.size()));
  }
}

void PlanarMap::add_borders(int region, std::vector<Border>& stretches) const {
  for (const int start : graph_.loops_of(region)) {
    int previous = region;
    int h = start;
    do {
      const int other = graph_.face(PlaneGraph::twin(h));
      if (other != region) {
        if (other != previous) stretches.push_back({other, 0.0});
        stretches.back().length_mm += graph_.length_mm(h);
      }
      previous = other;
      h = graph_.next(h);
    } while (h != start);
  }
}

std::vector<std::vector<Polygon>> PlanarMap::trace(const std::vector<int>& group_of_region,
                                                   int groups) const {
  std::vector<int> group = group_of_region;
  group[kOutside] = -1;
  return trace_boundaries(graph_, group, groups);
}

}  // namespace roomatlas::planar
