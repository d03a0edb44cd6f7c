// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "roomatlas/polyline/region.hpp"

namespace roomatlas {

/// The cells that hang together with `start` over edges and corners, the nearest first, where they
/// are few. What a building's walls enclose is small, what lies around the building is not: of that
/// only the front of the search is kept.
/// @param most parts of more cells are given as none
/// @param belongs whether a cell of the domain, other than `start`, may belong to the part:
///        `belongs(cell)`
/// @param is_done marked for every cell of the part, also of a large one; cells that are marked
///        already belong to none
template <typename Belongs>
[[nodiscard]] std::vector<Cell> small_part(const Cell& start, std::size_t most, Belongs belongs,
                                           CellMask& is_done) {
  std::vector<Cell> part;
  std::vector<Cell> front = {start};
  is_done.set(start, true);
  for (bool is_small = true; !front.empty();) {
    is_small = is_small && part.size() + front.size() <= most;
    if (is_small) part.insert(part.end(), front.begin(), front.end());
    std::vector<Cell> next;
    for (const Cell& at : front) {
      for_each_cell({{at.x - 1, at.y - 1}, {at.x + 2, at.y + 2}}, [&](const Cell& near) {
        if (!is_done.domain.contains(near) || is_done.at(near) || !belongs(near)) return;
        is_done.set(near, true);
        next.push_back(near);
      });
    }
    front = std::move(next);
    if (!is_small) part.clear();
  }
  return part;
}

}  // namespace roomatlas
