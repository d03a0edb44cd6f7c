// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/grid/cells.hpp"

namespace roomatlas {

/// A value for each cell of a box, row by row.
template <typename Value>
struct Raster {
  CellBox box;
  std::vector<Value> values;

  Raster() = default;
  explicit Raster(const CellBox& in, Value value = Value{}) : box(in), values(in.count(), value) {}

  /// The cell's value; `outside` beyond the box.
  [[nodiscard]] Value get(const Cell& cell, Value outside = Value{}) const {
    return box.contains(cell) ? values[box.index_of(cell)] : outside;
  }
  /// The cell for writing; it must lie in the box.
  [[nodiscard]] Value& operator[](const Cell& cell) { return values[box.index_of(cell)]; }
  [[nodiscard]] const Value& operator[](const Cell& cell) const {
    return values[box.index_of(cell)];
  }
};

}  // namespace roomatlas
