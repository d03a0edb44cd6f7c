// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <string>
#include <vector>

#include "roomatlas/polyline/clean_map.hpp"
#include "roomatlas/polyline/region.hpp"

namespace roomatlas::testing_polyline {

/// A map as one reads it: the first line is the northernmost row, the last line row 0, and the
/// first letter of each line column 0. '#' occupied, '.' empty, 'r' robot path, ' ' unknown.
using Drawing = std::vector<std::string>;

inline CellBox box_of(const Drawing& drawing) {
  const int width = drawing.empty() ? 0 : static_cast<int>(drawing.front().size());
  return {{0, 0}, {width, static_cast<int>(drawing.size())}};
}

inline char letter_at(const Drawing& drawing, const Cell& cell) {
  const std::size_t line = drawing.size() - 1 - static_cast<std::size_t>(cell.y);
  return drawing[line].at(static_cast<std::size_t>(cell.x));
}

/// `letter(cell)` for each cell of a box from (0, 0).
template <typename Letter>
Drawing drawn(const CellBox& box, Letter letter) {
  Drawing drawing;
  for (int y = box.max.y - 1; y >= 0; --y) {
    std::string& line = drawing.emplace_back();
    for (int x = 0; x < box.max.x; ++x) line += letter(Cell{x, y});
  }
  return drawing;
}

inline Drawing drawn(const CellMap& map, const CellBox& box) {
  return drawn(box, [&](const Cell& cell) {
    constexpr char kLetters[] = {' ', '.', '#', 'r'};  // in the order of CellState
    return kLetters[static_cast<std::size_t>(map.at(cell))];
  });
}

inline Drawing drawn(const CellMask& mask) {
  return drawn(mask.domain.bounds(), [&](const Cell& cell) { return mask.at(cell) ? '#' : '.'; });
}

inline CellMap map_of(const Drawing& drawing) {
  CellMap map{CellFrame{0.1}, box_of(drawing), {}};
  for_each_cell(map.box, [&](const Cell& cell) {
    const char letter = letter_at(drawing, cell);
    map.states.push_back(letter == '#'   ? CellState::occupied
                         : letter == '.' ? CellState::empty
                         : letter == 'r' ? CellState::robot_path
                                         : CellState::unknown);
  });
  return map;
}

inline CellMask mask_of(const Drawing& drawing) {
  CellMask mask(box_of(drawing));
  for_each_cell(mask.domain,
                [&](const Cell& cell) { mask.set(cell, letter_at(drawing, cell) == '#'); });
  return mask;
}

/// The grid that reads as the drawing: C = 15 at walls, -3 at empty cells, 0 or 0.5 at unknown
/// ones. A hit raises the neighbours as well, so that those are lowered again by rays of one cell.
inline HimmGrid grid_of(const Drawing& drawing) {
  const CellBox box = box_of(drawing);
  HimmGrid grid(0.1);
  const auto sweep_at = [&](const Cell& cell, bool is_obstacle) {
    const Point2 at = grid.frame().center_of(cell);
    grid.add_sweep({{{at, at}, is_obstacle}});
  };
  for_each_cell(box, [&](const Cell& cell) {
    for (int i = 0; i < 5 && letter_at(drawing, cell) == '#'; ++i) sweep_at(cell, true);
  });
  for_each_cell(box, [&](const Cell& cell) {
    const char letter = letter_at(drawing, cell);
    if (letter == '.') {
      while (grid.value(cell) > -3.0) sweep_at(cell, false);
    } else if (letter == ' ') {
      while (grid.value(cell) >= 1.0) sweep_at(cell, false);
    } else if (letter == 'r') {
      const Point2 at = grid.frame().center_of(cell);
      grid.mark_robot({at.x(), at.y(), 0.0}, {0.05, 0.05});
    }
  });
  for_each_cell({{-1, -1}, {box.max.x + 1, box.max.y + 1}}, [&](const Cell& cell) {
    while (!box.contains(cell) && grid.value(cell) >= 1.0) sweep_at(cell, false);
  });
  return grid;
}

/// Clutter: each cell draws its letter from `letters`.
inline Drawing random_drawing(std::mt19937& random, int width, int height,
                              const std::string& letters) {
  std::uniform_int_distribution<std::size_t> pick(0, letters.size() - 1);
  return drawn({{0, 0}, {width, height}}, [&](const Cell&) { return letters[pick(random)]; });
}

}  // namespace roomatlas::testing_polyline
