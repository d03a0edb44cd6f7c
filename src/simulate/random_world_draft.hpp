// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "random_stream.hpp"
#include "roomatlas/core/geometry.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas::random_world_draft {

[[nodiscard]] double between(RandomStream& random, double low, double high);
/// Evenly one of low, low + 1 ... high.
[[nodiscard]] int whole_between(RandomStream& random, int low, int high);

/// What is alike in a whole building.
struct Style {
  double wall_m = 0.2;
  double door_m = 0.9;         ///< about; no two need be alike
  double corridor_m = 2.0;     ///< wide
  double least_width_m = 2.4;  ///< of rooms along a corridor ...
  double most_width_m = 5.0;
  double depth_m = 4.0;        ///< ... and from it
  double joined_share = 0.15;  ///< of rooms with a door to their neighbour
  bool equal = false;          ///< all rooms of a row, their doors too

  [[nodiscard]] double mean_width_m() const { return (least_width_m + most_width_m) / 2.0; }
};

[[nodiscard]] Style drawn_style(RandomStream& random);

/// A width for a door in a wall between two corners, near to the style's.
[[nodiscard]] double drawn_door_m(RandomStream& random, const Style& style, double available_m);

/// A building while it is put together.
class Draft {
 public:
  explicit Draft(double wall_m) : wall_m_(wall_m) {}

  /// @returns the room's place in the list
  std::size_t add_room(Polygon outline, RoomKind kind);
  /// A door through one thickness of wall.
  /// @param out the door's middle on the face that `from` sees, theta out of it
  void add_door(std::size_t from, std::size_t to, const Pose2& out, double width_m);
  /// A body that stands in a room.
  void add_partition(Ring outline) { partitions_.push_back({std::move(outline), {}}); }

  [[nodiscard]] std::size_t room_count() const { return rooms_.size(); }
  /// The plan, turned about the origin; walls fill what lies around rooms.
  [[nodiscard]] FloorPlan plan(double turned_rad) const;

 private:
  [[nodiscard]] std::vector<Polygon> walls() const;

  double wall_m_;
  std::vector<PlanRoom> rooms_;
  std::vector<PlanDoor> doors_;
  std::vector<Polygon> openings_;  ///< a little longer than the wall is thick
  std::vector<Polygon> partitions_;
};

/// Where rooms lie along a wall of another one, their host: the wall's face is y = 0 from x = 0 on,
/// the host lies on the side of negative y.
struct Row {
  Pose2 world_from_row;
  double length_m = 0.0;
  double depth_m = 0.0;
  std::size_t host = 0;
};

/// How many rooms of the style fit in a length, at least one.
[[nodiscard]] int rooms_in(double length_m, const Style& style);

/// Fills a row with rooms; each gets to the host by its own door or by its neighbour's.
void add_row(Draft& draft, RandomStream& random, const Style& style, const Row& row, int count);

/// A corridor along x from the origin on, rooms on its sides from `bare_m` on.
struct Strip {
  Pose2 world_from_strip;
  double length_m = 0.0;
  double bare_m = 0.0;
  int left = 0;  ///< rooms
  int right = 0;
};

/// @returns the corridor's place in the list
std::size_t add_strip(Draft& draft, RandomStream& random, const Style& style, const Strip& strip);

[[nodiscard]] Ring rectangle(double min_x, double min_y, double max_x, double max_y);

}  // namespace roomatlas::random_world_draft
