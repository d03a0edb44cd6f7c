// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/polyline/region.hpp"

#include <algorithm>

namespace roomatlas {
namespace {

constexpr Cell kSides[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};  // east, north, west, south

Cell moved(const Cell& cell, const Cell& step) { return {cell.x + step.x, cell.y + step.y}; }

constexpr int kFar = 1 << 29;  // cells; beyond any domain, and differences of two stay numbers

std::vector<CellDomain::Span> spans_of(const CellDomain& domain, int y) {
  std::vector<CellDomain::Span> spans;
  domain.for_each_span(y, [&](const CellDomain::Span& span) { spans.push_back(span); });
  return spans;
}

/// What is looked for beside each cell.
struct Wanted {
  std::uint8_t value = 1;  ///< of the mask's bits
  bool beyond = false;     ///< cells beyond the domain are wanted too
};

/// Cells with a wanted one within `radius` in their row.
CellMask near_in_row(const CellMask& mask, int radius, const Wanted& wanted) {
  CellMask result(mask.domain);
  const CellBox& box = mask.domain.bounds();
  for (int y = box.min.y; y < box.max.y; ++y) {
    const std::vector<CellDomain::Span> spans = spans_of(mask.domain, y);
    int last = -kFar;
    for (const CellDomain::Span& span : spans) {
      if (wanted.beyond) last = span.from - 1;
      for (int x = span.from; x < span.to; ++x) {
        const std::size_t index = span.first + static_cast<std::size_t>(x - span.from);
        if (mask.bits[index] == wanted.value) last = x;
        result.bits[index] = x - last <= radius ? 1 : 0;
      }
    }
    last = kFar;
    for (auto span = spans.rbegin(); span != spans.rend(); ++span) {
      if (wanted.beyond) last = span->to;
      for (int x = span->to - 1; x >= span->from; --x) {
        const std::size_t index = span->first + static_cast<std::size_t>(x - span->from);
        if (mask.bits[index] == wanted.value) last = x;
        if (last - x <= radius) result.bits[index] = 1;
      }
    }
  }
  return result;
}

/// The same in their column, one way: rows from `first` on, each `step` farther.
void add_near_in_column(const CellMask& mask, int radius, const Wanted& wanted, int first, int step,
                        CellMask& result) {
  const CellBox& box = mask.domain.bounds();
  const auto columns = static_cast<std::size_t>(std::max(0, box.width()));
  // Rows are counted from the first, so that both ways are one.
  std::vector<int> last(columns, -kFar);    // row of the last wanted cell
  std::vector<int> before(columns, -kFar);  // row of the last cell of the domain
  for (int row = 0; row < box.height(); ++row) {
    mask.domain.for_each_span(first + step * row, [&](const CellDomain::Span& span) {
      for (int x = span.from; x < span.to; ++x) {
        const std::size_t index = span.first + static_cast<std::size_t>(x - span.from);
        const auto column = static_cast<std::size_t>(x - box.min.x);
        if (wanted.beyond && before[column] != row - 1) last[column] = row - 1;
        before[column] = row;
        if (mask.bits[index] == wanted.value) last[column] = row;
        if (row - last[column] <= radius) result.bits[index] = 1;
      }
    });
  }
}

CellMask near_in_column(const CellMask& mask, int radius, const Wanted& wanted) {
  CellMask result(mask.domain);
  const CellBox& box = mask.domain.bounds();
  add_near_in_column(mask, radius, wanted, box.min.y, 1, result);
  add_near_in_column(mask, radius, wanted, box.max.y - 1, -1, result);
  return result;
}

/// Calls `visit` with each 4-connected component of the cells for which `belongs` holds.
template <typename Belongs, typename Visit>
void for_each_component(const CellDomain& domain, Belongs belongs, Visit visit) {
  CellMask seen(domain);
  for_each_cell(domain, [&](const Cell& start) {
    if (seen.at(start) || !belongs(start)) return;
    std::vector<Cell> component{start};
    seen.set(start, true);
    for (std::size_t i = 0; i < component.size(); ++i) {
      for (const Cell& side : kSides) {
        const Cell next = moved(component[i], side);
        if (!domain.contains(next) || seen.at(next) || !belongs(next)) continue;
        seen.set(next, true);
        component.push_back(next);
      }
    }
    visit(component);
  });
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
  return near_in_column(near_in_row(mask, radius, {}), radius, {});
}

CellMask eroded(const CellMask& mask, int radius) {
  const CellMask outside_in_row = near_in_row(mask, radius, {.value = 0, .beyond = true});
  CellMask result = near_in_column(outside_in_row, radius, {.value = 1, .beyond = true});
  for (std::uint8_t& bit : result.bits) bit = 1 - bit;
  return result;
}

CellMask connected_to(const CellMask& mask, const std::vector<Cell>& seeds) {
  CellMask result(mask.domain);
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
      mask.domain, [&](const Cell& cell) { return !mask.at(cell); },
      [&](const std::vector<Cell>& component) {
        if (static_cast<std::int64_t>(component.size()) >= max_cells) return;
        if (std::any_of(component.begin(), component.end(),
                        [&](const Cell& cell) { return mask.domain.is_at_rim(cell); })) {
          return;
        }
        for (const Cell& cell : component) result.set(cell, true);
      });
  return result;
}

std::vector<CellBoundary> trace_boundaries(const CellMask& mask, const CellFrame& frame) {
  std::vector<bool> traced(mask.domain.count() * 4, false);
  const auto slot = [&](const CellEdge& edge) {
    return mask.domain.find(edge.cell) * 4 + static_cast<std::size_t>(edge.side);
  };
  std::vector<CellBoundary> boundaries;
  for_each_cell(mask.domain, [&](const Cell& cell) {
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
