// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/polyline/region.hpp"

#include <algorithm>

namespace roomatlas {
namespace {

constexpr Cell kSides[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};  // east, north, west, south

Cell moved(const Cell& cell, const Cell& step) { return {cell.x + step.x, cell.y + step.y}; }

/// The cells of a mask along one axis.
struct Lines {
  std::ptrdiff_t count = 0;
  std::ptrdiff_t across = 0;  ///< in the mask's list, from one line to the next
  std::ptrdiff_t length = 0;
  std::ptrdiff_t step = 0;  ///< from one cell of a line to the next
};
Lines rows_of(const CellBox& box) { return {box.height(), box.width(), box.width(), 1}; }
Lines columns_of(const CellBox& box) { return {box.width(), 1, box.height(), box.width()}; }

/// Cells within `radius` along the lines: those whose window holds a cell of the mask.
CellMask dilated_along(const CellMask& mask, const Lines& lines, int radius) {
  CellMask result(mask.box);
  for (std::ptrdiff_t line = 0; line < lines.count; ++line) {
    const auto at = [&](std::ptrdiff_t i) {
      return static_cast<std::size_t>(line * lines.across + i * lines.step);
    };
    int inside = 0;
    for (std::ptrdiff_t i = -radius; i < lines.length; ++i) {
      if (i + radius < lines.length) inside += mask.bits[at(i + radius)];
      if (i - radius > 0) inside -= mask.bits[at(i - radius - 1)];
      if (i >= 0) result.bits[at(i)] = inside > 0 ? 1 : 0;
    }
  }
  return result;
}

/// Calls `visit` with each 4-connected component of the cells for which `belongs` holds.
template <typename Belongs, typename Visit>
void for_each_component(const CellBox& box, Belongs belongs, Visit visit) {
  CellMask seen(box);
  for_each_cell(box, [&](const Cell& start) {
    if (seen.at(start) || !belongs(start)) return;
    std::vector<Cell> component{start};
    seen.set(start, true);
    for (std::size_t i = 0; i < component.size(); ++i) {
      for (const Cell& side : kSides) {
        const Cell next = moved(component[i], side);
        if (!box.contains(next) || seen.at(next) || !belongs(next)) continue;
        seen.set(next, true);
        component.push_back(next);
      }
    }
    visit(component);
  });
}

bool touches_rim(const CellBox& box, const Cell& cell) {
  return cell.x == box.min.x || cell.y == box.min.y || cell.x == box.max.x - 1 ||
         cell.y == box.max.y - 1;
}

/// An edge of a cell: `side` indexes kSides, the edge lies on that side of `cell`.
struct CellEdge {
  Cell cell;
  int side = 0;
};

/// The next edge of the boundary, walking with the mask on the left.
CellEdge next_edge(const CellMask& mask, const CellEdge& edge) {
  const Cell ahead_step = kSides[(edge.side + 1) % 4];
  const Cell ahead = moved(edge.cell, ahead_step);
  if (!mask.at(ahead)) return {edge.cell, (edge.side + 1) % 4};  // turn left around the cell
  const Cell outer = moved(ahead, kSides[edge.side]);
  if (!mask.at(outer)) return {ahead, edge.side};  // straight on
  return {outer, (edge.side + 3) % 4};             // turn right into the corner
}

}  // namespace

std::int64_t CellMask::count() const { return std::count(bits.begin(), bits.end(), 1); }

CellMask both(CellMask first, const CellMask& second) {
  for (std::size_t i = 0; i < first.bits.size(); ++i) first.bits[i] &= second.bits[i];
  return first;
}

CellMask either(CellMask first, const CellMask& second) {
  for (std::size_t i = 0; i < first.bits.size(); ++i) first.bits[i] |= second.bits[i];
  return first;
}

CellMask dilated(const CellMask& mask, int radius) {
  return dilated_along(dilated_along(mask, rows_of(mask.box), radius), columns_of(mask.box),
                       radius);
}

CellMask eroded(const CellMask& mask, int radius) {
  CellMask outside({{mask.box.min.x - radius, mask.box.min.y - radius},
                    {mask.box.max.x + radius, mask.box.max.y + radius}});
  for_each_cell(outside.box, [&](const Cell& cell) { outside.set(cell, !mask.at(cell)); });
  outside = dilated(outside, radius);
  CellMask result(mask.box);
  for_each_cell(mask.box, [&](const Cell& cell) { result.set(cell, !outside.at(cell)); });
  return result;
}

CellMask connected_to(const CellMask& mask, const std::vector<Cell>& seeds) {
  CellMask result(mask.box);
  std::vector<Cell> open;
  const auto take = [&](const Cell& cell) {
    if (!mask.at(cell) || result.at(cell)) return;
    result.set(cell, true);
    open.push_back(cell);
  };
  for (const Cell& seed : seeds) take(seed);
  while (!open.empty()) {
    const Cell at = open.back();
    open.pop_back();
    for (const Cell& side : kSides) take(moved(at, side));
  }
  return result;
}

CellMask holes_filled(const CellMask& mask, std::int64_t max_cells) {
  CellMask result = mask;
  for_each_component(
      mask.box, [&](const Cell& cell) { return !mask.at(cell); },
      [&](const std::vector<Cell>& component) {
        if (static_cast<std::int64_t>(component.size()) >= max_cells) return;
        if (std::any_of(component.begin(), component.end(),
                        [&](const Cell& cell) { return touches_rim(mask.box, cell); })) {
          return;
        }
        for (const Cell& cell : component) result.set(cell, true);
      });
  return result;
}

std::vector<CellBoundary> trace_boundaries(const CellMask& mask, const CellFrame& frame) {
  std::vector<bool> traced(mask.box.count() * 4, false);
  const auto slot = [&](const CellEdge& edge) {
    return mask.box.index_of(edge.cell) * 4 + static_cast<std::size_t>(edge.side);
  };
  std::vector<CellBoundary> boundaries;
  for_each_cell(mask.box, [&](const Cell& cell) {
    for (int side = 0; side < 4; ++side) {
      const CellEdge start{cell, side};
      if (!mask.at(cell) || mask.at(moved(cell, kSides[side])) || traced[slot(start)]) continue;
      CellBoundary& boundary = boundaries.emplace_back();
      for (CellEdge edge = start; !traced[slot(edge)]; edge = next_edge(mask, edge)) {
        traced[slot(edge)] = true;
        const Cell outside = moved(edge.cell, kSides[edge.side]);
        boundary.edge_midpoints.push_back((frame.center_of(edge.cell) + frame.center_of(outside)) /
                                          2.0);
        boundary.outside_cells.push_back(outside);
      }
    }
  });
  return boundaries;
}

}  // namespace roomatlas
