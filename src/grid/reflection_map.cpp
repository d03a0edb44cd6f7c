// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/grid/reflection_map.hpp"

#include <algorithm>
#include <limits>

namespace roomatlas {
namespace {

constexpr std::uint16_t kMost = std::numeric_limits<std::uint16_t>::max();  // a count holds no more

/// One more; a full cell is halved, which keeps its share.
void count(CellCounts& counts, std::uint16_t CellCounts::*which) {
  if (counts.*which == kMost) {
    counts.hits /= 2;
    counts.passes /= 2;
  }
  ++(counts.*which);
}

bool touches(const Cell& a, const Cell& b) {
  return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) <= 1;
}

}  // namespace

void ReflectionMap::add_sweep(const std::vector<Ray>& rays) {
  for (const Ray& ray : rays) {
    const Cell end = frame_.cell_of(ray.segment.b);
    for_each_cell_on_line(frame_.cell_of(ray.segment.a), end, [&](const Cell& cell) {
      if (ray.ends_at_obstacle && touches(cell, end)) return false;
      count(counts_.edit(cell), &CellCounts::passes);
      return true;
    });
    if (ray.ends_at_obstacle) count(counts_.edit(end), &CellCounts::hits);
  }
}

Point2 ReflectionMap::mean_hit(const Cell& cell) const {
  Point2 sum = Point2::Zero();
  double hits = 0.0;
  for_each_cell({{cell.x - 1, cell.y - 1}, {cell.x + 2, cell.y + 2}}, [&](const Cell& near) {
    const double weight = at(near).hits;
    sum += weight * frame_.center_of(near);
    hits += weight;
  });
  return hits > 0.0 ? Point2(sum / hits) : frame_.center_of(cell);
}

}  // namespace roomatlas
