// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/asr/asr.hpp"
#include "roomatlas/core/geometry.hpp"
#include "roomatlas/plan/floor_plan.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace roomatlas::random_building_layout {

constexpr double kWallM = 0.2;      // between two spaces
constexpr double kCorridorM = 2.2;  // wide

/// A doorway as one of its two spaces sees it.
struct LaidOpening {
  Pose2 world_from_pivot;  ///< mid-point of the door, theta out of the space
  double width_m = 0.0;
  RoomId beyond = 0;
};

/// A room or corridor: a rectangle along the axes.
struct Space {
  RoomId id = 0;
  RoomKind kind = RoomKind::room;
  Box2 box;
  std::vector<LaidOpening> openings;
};

/// The opening of a space that leads to a room; null where there is none.
[[nodiscard]] const LaidOpening* opening_to(const Space& space, RoomId beyond);

/// A doorway, once.
struct LaidDoor {
  RoomId from = 0;
  LaidOpening opening;  ///< as `from` sees it
};

/// A corridor with rooms on both sides.
struct Block {
  std::int64_t index = 0;
  std::int64_t strip = 0;
  std::int64_t column = 0;
  std::vector<Space> spaces;  ///< the corridor, then the southern, then the northern rooms
  /// Rooms joined side by side, in the order in which the robot drives along the corridor. All but
  /// the last of several surely have a door to the corridor. Link rooms are in none.
  std::vector<std::vector<std::size_t>> chains;
  std::optional<std::size_t> south_link;  ///< index of the narrow room at the block's end, which
  std::optional<std::size_t> north_link;  ///< leads to the next row where there is one
  std::vector<LaidDoor> doors;            ///< each door of the building is in one block
  [[nodiscard]] const Space& corridor() const { return spaces.front(); }
};

/// The plan of the building, as a function: any block can be asked for at any time.
class Layout {
 public:
  Layout(std::int64_t rooms, std::uint64_t seed);

  [[nodiscard]] std::int64_t blocks() const { return blocks_; }
  [[nodiscard]] Block block(std::int64_t index) const;
  /// Of the block at a place; nothing where the building does not reach.
  [[nodiscard]] std::optional<std::int64_t> index_at(std::int64_t strip, std::int64_t column) const;
  /// +1 where the robot drives a row along x, -1 where it drives against it.
  [[nodiscard]] static int heading_of(std::int64_t strip) { return strip % 2 == 0 ? 1 : -1; }

 private:
  struct Row;
  void add_row(Block& block, const Row& row) const;
  void add_ends(Block& block) const;
  [[nodiscard]] RoomId first_room(std::int64_t index) const;
  [[nodiscard]] RoomId link_room(std::int64_t index, bool north) const;
  [[nodiscard]] bool link_is_left(std::int64_t column) const;
  [[nodiscard]] double southern_depth_m(std::int64_t strip) const;

  std::int64_t rooms_;
  std::uint64_t seed_;
  std::int64_t blocks_;
  std::int64_t columns_;
  double width_m_;  ///< of each block, inside its end walls
};

}  // namespace roomatlas::random_building_layout
