// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/grid/himm_grid.hpp"
#include "roomatlas/plan/door.hpp"

namespace roomatlas {

struct DoorwayOptions {
  double min_width_m = 0.6;     ///< smaller takes furniture gaps for doors
  double max_width_m = 1.1;     ///< larger takes narrow corridors for doors
  double max_jamb_m = 1.0;      ///< each jamb is at most this far from the path
  double widening_m = 0.5;      ///< the room on both sides must be this much wider
  double occupied_value = 5.0;  ///< C from which a cell is a jamb; below epsilon, since jambs are
                                ///< seen by few readings
};

/// The doorway that the path goes through at a pose, if there is one: the narrowest chord between
/// two obstacles, within 40 degrees of the perpendicular to the motion, of a door's width, with
/// wider space 0.4 to 0.8 m ahead and behind.
/// Ask it some way behind the robot (0.6 m), where both jambs have been seen.
/// Not guaranteed: gaps between furniture look the same; whether an opening separates rooms is
/// decided offline.
/// @param grid_from_path position on the path; theta is the direction of motion
[[nodiscard]] std::optional<Doorway> find_doorway(const HimmGrid& grid, const Pose2& grid_from_path,
                                                  const DoorwayOptions& options);

}  // namespace roomatlas
