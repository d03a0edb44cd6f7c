// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <random>
#include <vector>

#include "roomatlas/grid/cell_domain.hpp"

namespace roomatlas::test {

/// A domain of random spans, with gaps between and below them: what a building with courtyards has.
inline CellDomain spotty_domain(std::mt19937& random, const CellBox& box) {
  std::vector<std::vector<CellDomain::Span>> rows;
  for (int y = box.min.y; y < box.max.y; ++y) {
    std::vector<CellDomain::Span>& row = rows.emplace_back();
    int x = box.min.x + static_cast<int>(random() % 4U);
    while (x < box.max.x && random() % 6U != 0U) {
      const int to = std::min(box.max.x, x + 1 + static_cast<int>(random() % 9U));
      row.push_back({x, to, 0});
      x = to + 1 + static_cast<int>(random() % 5U);
    }
  }
  return CellDomain::from_rows(box.min.y, std::move(rows));
}

}  // namespace roomatlas::test
