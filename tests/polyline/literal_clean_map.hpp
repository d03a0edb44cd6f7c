// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <vector>

#include "roomatlas/polyline/clean_map.hpp"

namespace roomatlas::testing_polyline {

/// Whether the line Gamma from p_a to p_b meets the robot's path before an occupied cell.
inline bool line_meets_path(const HimmGrid& grid, double epsilon, const Cell& p_a,
                            const Cell& p_b) {
  bool found = false;
  for_each_cell_on_line(p_a, p_b, [&](const Cell& p_t) {
    if (p_t == p_a) return true;
    found = grid.is_robot_path(p_t);
    return !found && grid.value(p_t) <= epsilon;
  });
  return found;
}

/// The inner loops of Fig. 5: rays from p_a to every p_b of the square of +-max_dist around it.
inline bool literal_found(const HimmGrid& grid, double epsilon, int max_dist, const Cell& p_a) {
  for (int j = -max_dist; j <= max_dist; ++j) {
    for (int i = -max_dist; i <= max_dist; ++i) {
      if (line_meets_path(grid, epsilon, p_a, {p_a.x + i, p_a.y + j})) return true;
    }
  }
  return false;
}

/// A map in which an empty or occupied cell stays where `found(cell)`.
template <typename Found>
CellMap cleaned_where(const HimmGrid& grid, double epsilon, Found found) {
  CellMap map{grid.frame(), grid.box(), {}};
  for_each_cell(grid.box(), [&](const Cell& cell) {
    const double value = grid.value(cell);
    CellState state = CellState::unknown;
    if (grid.is_robot_path(cell)) {
      state = CellState::robot_path;
    } else if (value > epsilon && found(cell)) {
      state = CellState::occupied;
    } else if (value < 0.0 && found(cell)) {
      state = CellState::empty;
    }
    map.states.push_back(state);
  });
  return map;
}

/// CleanMap as printed in the paper's Fig. 5, for empty cells too as the text of III.B has it.
inline CellMap literal_clean_map(const HimmGrid& grid, double epsilon, int max_dist) {
  return cleaned_where(grid, epsilon, [&](const Cell& cell) {
    return literal_found(grid, epsilon, max_dist, cell);
  });
}

/// The shipped question without shortcuts: is the line to any of the `goals` clear?
inline CellMap clean_map_by_goals(const HimmGrid& grid, double epsilon, int max_dist,
                                  const std::vector<Cell>& goals) {
  return cleaned_where(grid, epsilon, [&](const Cell& cell) {
    for (const Cell& goal : goals) {
      if (std::abs(goal.x - cell.x) > max_dist || std::abs(goal.y - cell.y) > max_dist) continue;
      if (line_meets_path(grid, epsilon, cell, goal)) return true;
    }
    return false;
  });
}

/// The path's cells, or those of them with a side that is not path.
inline std::vector<Cell> path_cells(const HimmGrid& grid, bool only_rim) {
  std::vector<Cell> path;
  for_each_cell(grid.box(), [&](const Cell& cell) {
    const int sides =
        grid.is_robot_path({cell.x - 1, cell.y}) + grid.is_robot_path({cell.x + 1, cell.y}) +
        grid.is_robot_path({cell.x, cell.y - 1}) + grid.is_robot_path({cell.x, cell.y + 1});
    if (grid.is_robot_path(cell) && !(only_rim && sides == 4)) path.push_back(cell);
  });
  return path;
}

}  // namespace roomatlas::testing_polyline
