// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/grid/cell_domain.hpp"

namespace roomatlas {

/// A value for each cell of a domain, in the order of their numbers.
template <typename Value>
struct Raster {
  CellDomain domain;
  std::vector<Value> values;

  Raster() = default;
  explicit Raster(const CellBox& in, Value value = Value{}) : Raster(CellDomain(in), value) {}
  explicit Raster(const CellDomain& in, Value value = Value{})
      : domain(in), values(in.count(), value) {}

  /// The cell's value; `outside` beyond the domain.
  [[nodiscard]] Value get(const Cell& cell, Value outside = Value{}) const {
    const std::size_t index = domain.find(cell);
    return index != CellDomain::kNone ? values[index] : outside;
  }
  /// The cell for writing; it must belong to the domain.
  [[nodiscard]] Value& operator[](const Cell& cell) { return values[domain.find(cell)]; }
  [[nodiscard]] const Value& operator[](const Cell& cell) const {
    return values[domain.find(cell)];
  }
};

}  // namespace roomatlas
