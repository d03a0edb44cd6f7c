// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "obstacles.hpp"
#include "roomatlas/grid/cells.hpp"
#include "roomatlas/simulate/furnish.hpp"

namespace roomatlas {

/// Where a robot can be in one room and in its doorways, while furniture comes in piece by piece.
class RoomWays {
 public:
  /// @param standing all that stands in the world
  RoomWays(const FloorPlan& world, const PlanRoom& room, const ObstacleIndex& standing,
           const FurnishOptions& options);

  /// Puts something there if no free place is cut off by it.
  /// @param way_clearance_m of the middle line of ways from it
  /// @returns false where it would be; then nothing has changed
  bool add(const Ring& outline, double way_clearance_m);

 private:
  enum Flag : std::uint8_t {
    kCanTurn = 1,  ///< the robot can turn there
    kOnWay = 2,    ///< a way can lead there
    kAtDoor = 4,
  };
  void mark_floor(const FloorPlan& world, const PlanRoom& room);
  void close_near(const Segment2& edge, double radius_m);
  void close_bodies(const FloorPlan& world);
  void number_places();
  /// Visits the cells that hang together with `start` by a flag.
  template <typename Visit>
  void flood(std::size_t start, std::uint8_t flag, Visit visit);
  [[nodiscard]] bool hangs_together(std::uint8_t flag, std::size_t least_cells);

  CellFrame frame_;
  CellBox box_;
  double turning_m_;                 ///< the robot's half diagonal
  std::vector<std::uint8_t> flags_;  ///< a cell of the box each
  std::vector<int> places_;          ///< connected pieces of floor when the room was empty
  int place_count_ = 0;
  std::vector<std::uint32_t> seen_;  ///< in which search
  std::uint32_t search_ = 0;
  std::vector<std::size_t> open_;  ///< of the search
};

}  // namespace roomatlas
