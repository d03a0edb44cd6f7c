// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/grid/himm_grid.hpp"

#include <cstdint>
#include <vector>

namespace roomatlas {

/// What an explorer has sensed: a HIMM grid of its own, fine enough to find its way through
/// doors, and for each cell how many obstacles are too near for the robot.
class ExplorerMap {
 public:
  explicit ExplorerMap(const RobotFootprint& footprint);

  void add(const RangeReading& reading, const Pose2& map_from_robot);

  [[nodiscard]] const HimmGrid& himm() const { return himm_; }
  [[nodiscard]] const CellFrame& frame() const { return himm_.frame(); }
  [[nodiscard]] const CellBox& box() const { return himm_.box(); }
  [[nodiscard]] bool is_obstacle(const Cell& cell) const;
  /// Seen free, and the robot's middle can be here without its sides touching an obstacle.
  [[nodiscard]] bool is_passable(const Cell& cell) const;
  /// So near an obstacle that the robot could not turn freely.
  [[nodiscard]] bool is_tight(const Cell& cell) const;
  /// Passable, and beside enough unknown cells, or a large enough unknown, that there is something
  /// to see.
  [[nodiscard]] bool is_frontier(const Cell& cell) const;
  /// Seen, and a little away from obstacles: a thinner robot might be here. One hit, which may be
  /// crosstalk, makes no obstacle.
  [[nodiscard]] bool is_narrow(const Cell& cell) const;
  /// Whether a robot of this pose has obstacles to its left and to its right, as in a doorway.
  [[nodiscard]] bool is_between_obstacles(const Pose2& map_from_robot) const;
  /// Beside enough unknown cells of a large unknown.
  [[nodiscard]] bool borders_large_unknown(const Cell& cell) const;
  /// The centres of obstacle cells within a distance.
  [[nodiscard]] std::vector<Point2> obstacles_within(const Point2& center, double radius_m) const;

 private:
  struct Nearness {
    std::uint16_t touching = 0;  ///< obstacles nearer than half the robot's width
    std::uint16_t turning = 0;   ///< obstacles nearer than half its diagonal
    bool is_obstacle = false;
  };

  struct UnknownAround {
    int cells = 0;
    Cell one;  ///< of them
  };

  [[nodiscard]] UnknownAround unknown_around(const Cell& cell) const;
  [[nodiscard]] bool is_in_large_unknown(const Cell& cell) const;
  void grow();
  void update(const Cell& cell);
  [[nodiscard]] const Nearness* nearness(const Cell& cell) const;

  RobotFootprint footprint_;
  HimmGrid himm_;
  std::vector<Cell> touching_disc_;
  std::vector<Cell> turning_disc_;
  CellBox box_;
  std::vector<Nearness> nearness_;
};

}  // namespace roomatlas
