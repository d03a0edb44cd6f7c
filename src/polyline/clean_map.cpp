// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/polyline/clean_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomatlas {
namespace {

CellMap decided(const HimmGrid& grid, double epsilon) {
  CellMap map{grid.frame(), grid.box(), {}};
  map.states.reserve(map.box.count());
  for_each_cell(map.box, [&](const Cell& cell) {
    const double value = grid.value(cell);
    map.states.push_back(grid.is_robot_path(cell) ? CellState::robot_path
                         : value > epsilon        ? CellState::occupied
                         : value < 0.0            ? CellState::empty
                                                  : CellState::unknown);
  });
  return map;
}

/// The path's cells that are not surrounded by path on all four sides. A line to an inner cell
/// meets one of these first, or slips between two of them at a corner: the few cells that only
/// such a line sees are given up for the speed.
std::vector<Cell> rim_of_path(const CellMap& map) {
  std::vector<Cell> rim;
  for_each_cell(map.box, [&](const Cell& cell) {
    if (map.at(cell) != CellState::robot_path) return;
    const bool inner = map.at({cell.x + 1, cell.y}) == CellState::robot_path &&
                       map.at({cell.x - 1, cell.y}) == CellState::robot_path &&
                       map.at({cell.x, cell.y + 1}) == CellState::robot_path &&
                       map.at({cell.x, cell.y - 1}) == CellState::robot_path;
    if (!inner) rim.push_back(cell);
  });
  return rim;
}

bool line_is_clear(const CellMap& map, const Cell& from, const Cell& to) {
  bool clear = true;
  for_each_cell_on_line(from, to, [&](const Cell& cell) {
    if (cell == from) return true;
    const CellState state = map.states[map.box.index_of(cell)];  // both ends lie in the box
    clear = state != CellState::occupied;
    return clear && state != CellState::robot_path;
  });
  return clear;
}

/// Tells whether the path can be seen from a cell. Keeps a buffer, so that asking allocates
/// nothing.
class PathVisibility {
 public:
  PathVisibility(const CellMap& map, int range_cells)
      : map_(map), rim_(rim_of_path(map)), range_cells_(range_cells) {}

  bool sees_path(const Cell& from) {
    candidates_.clear();
    for (std::size_t i = 0; i < rim_.size(); ++i) {
      const int dx = std::abs(rim_[i].x - from.x);
      const int dy = std::abs(rim_[i].y - from.y);
      if (dx <= range_cells_ && dy <= range_cells_) candidates_.push_back({dx * dx + dy * dy, i});
    }
    if (candidates_.empty()) return false;
    const Candidate nearest = *std::min_element(candidates_.begin(), candidates_.end());
    if (line_is_clear(map_, from, rim_[nearest.rim_index])) return true;
    // any will do: near ones are seen more often, and sorting them all would cost more than it
    // saves
    const auto far =
        std::partition(candidates_.begin(), candidates_.end(), [&](const Candidate& candidate) {
          return candidate.squared_distance <= kNear * kNear * nearest.squared_distance;
        });
    const auto is_seen = [&](const Candidate& candidate) {
      return line_is_clear(map_, from, rim_[candidate.rim_index]);
    };
    return std::any_of(candidates_.begin(), far, is_seen) ||
           std::any_of(far, candidates_.end(), is_seen);
  }

  /// Squared distance in cells to the nearest cell of the path.
  [[nodiscard]] int squared_distance_to_path(const Cell& from) const {
    int nearest = std::numeric_limits<int>::max();
    for (const Cell& cell : rim_) {
      const int dx = cell.x - from.x;
      const int dy = cell.y - from.y;
      nearest = std::min(nearest, dx * dx + dy * dy);
    }
    return nearest;
  }

 private:
  static constexpr int kNear = 2;  ///< times as far as the nearest: looked at first

  struct Candidate {
    int squared_distance = 0;
    std::size_t rim_index = 0;
    auto operator<=>(const Candidate&) const = default;
  };
  const CellMap& map_;
  std::vector<Cell> rim_;
  int range_cells_;
  std::vector<Candidate> candidates_;
};

void break_blocks(CellMap& map, const PathVisibility& visibility) {
  for_each_cell(map.box, [&](const Cell& corner) {
    const Cell block[4] = {
        corner, {corner.x + 1, corner.y}, {corner.x, corner.y + 1}, {corner.x + 1, corner.y + 1}};
    if (!std::all_of(std::begin(block), std::end(block),
                     [&](const Cell& cell) { return map.at(cell) == CellState::occupied; })) {
      return;
    }
    const Cell* farthest =
        std::max_element(std::begin(block), std::end(block), [&](const Cell& a, const Cell& b) {
          return visibility.squared_distance_to_path(a) < visibility.squared_distance_to_path(b);
        });
    map.states[map.box.index_of(*farthest)] = CellState::unknown;
  });
}

}  // namespace

std::int64_t CellMap::count(CellState state) const {
  return std::count(states.begin(), states.end(), state);
}

CellMap clean_map(const HimmGrid& grid, const CleanOptions& options) {
  const CellMap map = decided(grid, options.epsilon);
  const auto range_cells = static_cast<int>(std::lround(options.max_range_m / grid.frame().cell_m));
  PathVisibility visibility(map, range_cells);
  CellMap cleaned = map;
  for_each_cell(map.box, [&](const Cell& cell) {
    const CellState state = map.at(cell);
    if (state != CellState::occupied && state != CellState::empty) return;
    if (!visibility.sees_path(cell)) cleaned.states[map.box.index_of(cell)] = CellState::unknown;
  });
  if (options.thin) break_blocks(cleaned, visibility);
  return cleaned;
}

}  // namespace roomatlas
