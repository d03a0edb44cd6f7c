// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement.hpp"

#include <algorithm>
#include <cmath>

#include "roomatlas/planar/planar_map.hpp"

namespace roomatlas {
namespace {

/// A line of a number that is none would take all others with it.
bool is_plausible(const DraftLine& line) {
  return planar::is_plausible(line.segment.a) && planar::is_plausible(line.segment.b);
}

planar::MillimetreGrid grid_around(const std::vector<DraftLine>& lines) {
  Box2 box;
  for (const DraftLine& line : lines) {
    if (!is_plausible(line)) continue;
    box.extend(line.segment.a);
    box.extend(line.segment.b);
  }
  return planar::MillimetreGrid(box);
}

/// Lines as edges whose ring is the place of their line.
planar::PlaneGraph graph_of(const std::vector<DraftLine>& lines,
                            const planar::MillimetreGrid& grid) {
  planar::EdgeSet set;
  set.fine = grid.fine();
  planar::PointNumbers numbers(set.points_mm, 2 * lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!is_plausible(lines[i])) continue;
    const int from = numbers.number_of(grid.to_grid(lines[i].segment.a));
    const int to = numbers.number_of(grid.to_grid(lines[i].segment.b));
    if (from != to) set.edges.push_back({from, to, static_cast<int>(i)});
  }
  return planar::PlaneGraph(planar::cut_where_they_meet(std::move(set)));
}

}  // namespace

Arrangement::Arrangement(const std::vector<DraftLine>& lines)
    : grid_(grid_around(lines)), graph_(graph_of(lines, grid_)) {
  for (int half_edge = 0; half_edge < graph_.half_edge_count(); half_edge += 2) {
    const int back = planar::PlaneGraph::twin(half_edge);
    Border border;
    border.left = graph_.face(half_edge);
    border.right = graph_.face(back);
    if (border.left == border.right) continue;  // a line that ends in a cell
    border.segment = {grid_.to_metres(graph_.point(graph_.origin(half_edge))),
                      grid_.to_metres(graph_.point(graph_.origin(back)))};
    for (const planar::RingUse& use : graph_.uses(half_edge / 2)) {
      const DraftLine& line = lines[static_cast<std::size_t>(use.ring)];
      border.prominence_m = std::max(border.prominence_m, line.prominence_m);
      border.is_wall = border.is_wall || line.is_wall;
    }
    borders_.push_back(border);
  }
}

std::vector<std::vector<Polygon>> Arrangement::trace(const std::vector<int>& group_of_cell,
                                                     int groups) const {
  auto polygons = planar::trace_boundaries(graph_, group_of_cell, groups);
  for (auto& of_group : polygons) of_group = grid_.to_metres(of_group);
  return polygons;
}

Arrangement::Rows Arrangement::rows_of(double step_m) const {
  Box2 box;
  for (const Border& border : borders_) {
    box.extend(border.segment.a);
    box.extend(border.segment.b);
  }
  Rows rows;
  if (box.empty()) return rows;
  rows.from = box.min;
  rows.step_m = step_m;
  rows.count = static_cast<int>(std::ceil(box.size().y() / step_m));
  rows.borders_of_row.resize(static_cast<std::size_t>(rows.count));
  for (std::size_t i = 0; i < borders_.size(); ++i) {
    const Segment2& segment = borders_[i].segment;
    const double low = std::min(segment.a.y(), segment.b.y());
    const double high = std::max(segment.a.y(), segment.b.y());
    // Rows whose middle lies in [low, high): each crossing once, also at a vertex.
    const auto first = static_cast<int>(std::ceil((low - rows.from.y()) / step_m - 0.5));
    for (int row = std::max(0, first); row < rows.count; ++row) {
      if (rows.from.y() + (row + 0.5) * step_m >= high) break;
      rows.borders_of_row[static_cast<std::size_t>(row)].push_back(static_cast<int>(i));
    }
  }
  return rows;
}

std::vector<Arrangement::Crossing> Arrangement::crossings_at(const Rows& rows, int row) const {
  const double y_m = rows.from.y() + (row + 0.5) * rows.step_m;
  std::vector<Crossing> crossings;
  for (const int index : rows.borders_of_row[static_cast<std::size_t>(row)]) {
    const Border& border = borders_[static_cast<std::size_t>(index)];
    const auto& [a, b] = border.segment;
    const double x_m = a.x() + (b.x() - a.x()) * (y_m - a.y()) / (b.y() - a.y());
    const auto [low_m, high_m] = std::minmax({a.x(), b.x()});  // nearly level ones round badly
    crossings.push_back(
        {std::clamp(x_m, low_m, high_m), b.y() > a.y() ? border.right : border.left});
  }
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& p, const Crossing& q) { return p.x_m < q.x_m; });
  return crossings;
}

}  // namespace roomatlas
