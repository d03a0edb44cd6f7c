// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace roomatlas::io {

/// A rectangle of cells; (0, 0) is the lower left one.
template <typename T>
class CellGrid {
 public:
  CellGrid() = default;
  CellGrid(int width, int height, T value = T())
      : width_(width),
        height_(height),
        cells_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), value) {}

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] bool has(int x, int y) const {
    return x >= 0 && y >= 0 && x < width_ && y < height_;
  }
  [[nodiscard]] T& operator()(int x, int y) { return cells_[index(x, y)]; }
  [[nodiscard]] const T& operator()(int x, int y) const { return cells_[index(x, y)]; }
  /// The cell's value, or another one outside of the grid.
  [[nodiscard]] T get(int x, int y, T outside) const {
    return has(x, y) ? cells_[index(x, y)] : outside;
  }

  [[nodiscard]] auto begin() const { return cells_.begin(); }
  [[nodiscard]] auto end() const { return cells_.end(); }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<T> cells_;
};

}  // namespace roomatlas::io
