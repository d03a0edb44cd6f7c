// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "explorer_map.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace roomatlas {

/// Finds the robot's ways over its map: Dijkstra's algorithm over passable cells, eight
/// neighbours, cells near obstacles at a higher price.
class PathFinder {
 public:
  using CellTest = std::function<bool(const Cell&)>;

  /// The cheapest way from `start` to a cell that `is_goal` accepts, both ends included; nothing
  /// where there is none. Cells that `is_closed` are not entered. The robot may stand where it
  /// should not: cells beside it need not be passable.
  [[nodiscard]] std::optional<Polyline> way(const ExplorerMap& map, const Point2& start,
                                            const CellTest& is_goal, const CellTest& is_closed);

  /// Whether the last search came past the cell.
  [[nodiscard]] bool reached(const Cell& cell) const;

 private:
  struct Visit {
    std::uint32_t search = 0;  ///< the search to which the rest belongs
    bool done = false;
    float cost_m = 0.0F;
    Cell from;
  };
  void follow(const CellBox& box);

  CellBox box_;
  std::vector<Visit> visits_;
  std::uint32_t search_ = 0;
};

/// A pose on the way's i-th point, along its direction there.
[[nodiscard]] Pose2 pose_on_way(const Polyline& way, std::size_t i);

/// On the near side of a doorway in which a way's pose stands.
[[nodiscard]] Point2 a_metre_before(const Pose2& map_from_way);

}  // namespace roomatlas
