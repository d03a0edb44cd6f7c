// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "furnish_site.hpp"
#include "furnish_ways.hpp"
#include "random_stream.hpp"

#include <optional>
#include <vector>

namespace roomatlas {

/// How many pieces a room would hold; those that find no place are left out.
struct Inventory {
  int rows = 0;     ///< of cupboards and shelves, along walls
  int islands = 0;  ///< rows of shelves that stand free
  int desks = 0;    ///< along walls, with a chair each
  int tables = 0;   ///< that stand free, with chairs around
  int boxes = 0;
  double longest_row_m = 4.0;
  double deepest_row_m = 0.6;
};

/// By kind and size: an office, a hall, a store, a corridor. A room that nobody named a corridor is
/// one where it is narrow and long.
/// @param amount times what such a room usually holds
[[nodiscard]] Inventory inventory_of(const PlanRoom& room, double amount, RandomStream& random);

/// Puts furniture into one room.
class RoomFurnisher {
 public:
  /// @param site, ways, furniture get what finds a place
  RoomFurnisher(const PlanRoom& room, const FurnishOptions& options, FurnishSite& site,
                RoomWays& ways, std::vector<PlanFurniture>& furniture, RandomStream& random);

  void put(const Inventory& inventory);

 private:
  struct Size {
    double length_m = 0.0;
    double depth_m = 0.0;
  };
  void put_row(const Inventory& inventory);
  void put_island();
  void put_desk();
  void put_table();
  void put_chairs(const Pose2& world_from_table, const Size& table, bool has_legs);
  bool put_chair(const Pose2& world_from_chair, bool has_legs);
  void put_box();
  /// @returns the middle of its back, y pointing away from the wall
  std::optional<Pose2> put_at_wall(const Size& size);
  /// @returns its middle, x along its length
  std::optional<Pose2> put_free(const Size& size, bool along_walls);
  bool put_piece(const Ring& outline, const std::vector<Ring>& bodies, FurnitureKind kind);
  [[nodiscard]] bool is_in_room(const Ring& outline) const;
  [[nodiscard]] std::optional<Point2> some_place();
  [[nodiscard]] double between(double low, double high);

  const PlanRoom& room_;
  const FurnishOptions& options_;
  FurnishSite& site_;
  RoomWays& ways_;
  std::vector<PlanFurniture>& furniture_;
  RandomStream& random_;
  std::vector<Segment2> walls_;  ///< straight stretches of the outline, the room on their left
  double direction_rad_ = 0.0;   ///< of the longest
};

}  // namespace roomatlas
