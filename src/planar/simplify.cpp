// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/planar/simplify.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace roomatlas::planar {
namespace {

/// The index of the vertex farthest from the first.
std::size_t farthest_from_first(const Ring& ring) {
  std::size_t farthest = 0;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    if ((ring[i] - ring[0]).squaredNorm() > (ring[farthest] - ring[0]).squaredNorm()) farthest = i;
  }
  return farthest;
}

/// Marks the vertices to keep between two that are kept.
void mark(const Ring& ring, std::size_t first, std::size_t last, double tolerance,
          std::vector<char>& is_kept) {
  std::vector<std::pair<std::size_t, std::size_t>> open = {{first, last}};
  const auto vertex = [&](std::size_t i) -> const Point2& {
    return ring[i < ring.size() ? i : i - ring.size()];
  };
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    const Point2& start = vertex(from);
    const Point2 along = vertex(to) - start;
    const double inverse = along.squaredNorm() > 0.0 ? 1.0 / along.squaredNorm() : 0.0;
    double worst = tolerance * tolerance;
    std::size_t at = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const Point2 to_vertex = vertex(i) - start;
      const double fraction = std::clamp(to_vertex.dot(along) * inverse, 0.0, 1.0);
      const double off = (to_vertex - fraction * along).squaredNorm();
      if (off <= worst) continue;
      worst = off;
      at = i;
    }
    if (at == from) continue;
    is_kept[at % ring.size()] = 1;
    open.emplace_back(from, at);
    open.emplace_back(at, to);
  }
}

}  // namespace

std::vector<std::size_t> corners_of(const Ring& ring, double tolerance) {
  std::vector<std::size_t> all(ring.size());
  std::iota(all.begin(), all.end(), 0);
  if (ring.size() < 4) return all;
  const std::size_t far = farthest_from_first(ring);
  std::vector<char> is_kept(ring.size(), 0);
  is_kept[0] = 1;
  is_kept[far] = 1;
  mark(ring, 0, far, tolerance, is_kept);
  mark(ring, far, ring.size(), tolerance, is_kept);
  std::vector<std::size_t> kept;
  for (const std::size_t i : all) {
    if (is_kept[i] != 0) kept.push_back(i);
  }
  return kept.size() < 3 ? all : kept;
}

Ring simplified(const Ring& ring, double tolerance) {
  Ring kept;
  for (const std::size_t i : corners_of(ring, tolerance)) kept.push_back(ring[i]);
  return kept;
}

Polygon simplified(const Polygon& polygon, double tolerance) {
  Polygon simple{simplified(polygon.outer, tolerance), {}};
  for (const Ring& hole : polygon.holes) simple.holes.push_back(simplified(hole, tolerance));
  return simple;
}

}  // namespace roomatlas::planar
