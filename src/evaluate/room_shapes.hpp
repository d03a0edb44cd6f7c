// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/plan/floor_plan.hpp"

#include <vector>

namespace roomatlas {

/// What overlaps need of a room.
struct RoomShape {
  std::vector<Polygon> parts;
  double area_m2 = 0.0;
  Box2 box;
};

/// The rooms of a plan, in its order, in the truth's frame.
[[nodiscard]] std::vector<RoomShape> shapes_of(const FloorPlan& plan, const Pose2& truth_from_plan);

/// Areas that the rooms of two plans share, in square metres.
struct Overlaps {
  std::vector<RoomShape> rooms;
  std::vector<RoomShape> true_rooms;
  std::vector<std::vector<double>> shared_m2;  ///< [room][true room]

  [[nodiscard]] double iou(std::size_t room, std::size_t true_room) const;
  /// Of a room, the area that is in true rooms, and the largest part of it that is in one.
  [[nodiscard]] double shared_of_room_m2(std::size_t room) const;
  [[nodiscard]] double largest_of_room_m2(std::size_t room) const;
  /// The same of a true room.
  [[nodiscard]] double shared_of_true_room_m2(std::size_t true_room) const;
  [[nodiscard]] double largest_of_true_room_m2(std::size_t true_room) const;
};
[[nodiscard]] Overlaps overlaps_of(const FloorPlan& plan, const FloorPlan& truth,
                                   const Pose2& truth_from_plan);

}  // namespace roomatlas
