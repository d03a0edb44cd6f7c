// SPDX-License-Identifier: GPL-3.0-or-later
#include "trace_cells.hpp"

#include <array>
#include <utility>

namespace roomatlas::io {
namespace {

// Directions: 0 right, 1 up, 2 left, 3 down.
constexpr std::array<int, 4> kStepX = {1, 0, -1, 0};
constexpr std::array<int, 4> kStepY = {0, 1, 0, -1};  // of the same

/// Numbers the 4-connected regions of equal values from 1, and notes each one's value.
CellGrid<int> number_regions(const CellGrid<int>& values, std::vector<TracedRegion>& regions) {
  CellGrid<int> numbers(values.width(), values.height(), 0);
  std::vector<std::pair<int, int>> open;
  for (int y0 = 0; y0 < values.height(); ++y0) {
    for (int x0 = 0; x0 < values.width(); ++x0) {
      const int value = values(x0, y0);
      if (value == 0 || numbers(x0, y0) != 0) continue;
      regions.push_back({value, {}});
      const int number = static_cast<int>(regions.size());
      numbers(x0, y0) = number;
      open.emplace_back(x0, y0);
      while (!open.empty()) {
        const auto [x, y] = open.back();
        open.pop_back();
        for (std::size_t d = 0; d < 4; ++d) {
          const int nx = x + kStepX[d];
          const int ny = y + kStepY[d];
          if (!values.has(nx, ny) || values(nx, ny) != value || numbers(nx, ny) != 0) continue;
          numbers(nx, ny) = number;
          open.emplace_back(nx, ny);
        }
      }
    }
  }
  return numbers;
}

/// The corner of a cell where its side in a direction begins: the lower left one for its lower
/// side (direction 0), and so on counter-clockwise.
Point2 corner(int x, int y, std::size_t direction) {
  return {x + (direction == 1 || direction == 2 ? 1 : 0), y + (direction >= 2 ? 1 : 0)};
}

/// Follows a boundary from the lower side of a cell, the region on the left hand, and marks the
/// lower sides that it passes.
Ring follow(const CellGrid<int>& numbers, int x, int y, CellGrid<char>& passed) {
  const int number = numbers(x, y);
  Ring ring;
  std::size_t direction = 0;
  while (direction != 0 || passed(x, y) == 0) {
    if (direction == 0) passed(x, y) = 1;
    const int ahead_x = x + kStepX[direction];
    const int ahead_y = y + kStepY[direction];
    const std::size_t right = (direction + 3) % 4;
    const int right_x = ahead_x + kStepX[right];
    const int right_y = ahead_y + kStepY[right];
    if (numbers.get(ahead_x, ahead_y, 0) != number) {
      direction = (direction + 1) % 4;
      ring.push_back(corner(x, y, direction));
    } else if (numbers.get(right_x, right_y, 0) != number) {
      x = ahead_x, y = ahead_y;
    } else {
      x = right_x, y = right_y;
      direction = right;
      ring.push_back(corner(x, y, direction));
    }
  }
  return ring;
}

}  // namespace

std::vector<TracedRegion> trace_cells(const CellGrid<int>& values) {
  std::vector<TracedRegion> regions;
  const CellGrid<int> numbers = number_regions(values, regions);
  CellGrid<char> passed(values.width(), values.height(), 0);
  for (int y = 0; y < values.height(); ++y) {
    for (int x = 0; x < values.width(); ++x) {
      const int number = numbers(x, y);
      if (number == 0 || passed(x, y) != 0 || numbers.get(x, y - 1, 0) == number) continue;
      Polygon& outline = regions[static_cast<std::size_t>(number - 1)].outline;
      // A region's first cell is its lowest, which lies on the outer ring.
      Ring ring = follow(numbers, x, y, passed);
      if (outline.outer.empty()) {
        outline.outer = std::move(ring);
      } else {
        outline.holes.push_back(std::move(ring));
      }
    }
  }
  return regions;
}

}  // namespace roomatlas::io
