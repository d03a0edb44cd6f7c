// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pictures/picture.hpp"
#include "roomatlas/core/pose2.hpp"
#include "roomatlas/plan/floor_plan.hpp"

#include <optional>
#include <string>

namespace roomatlas::io {

/// How to read an occupancy picture; the words are those of a nav2 map file.
struct OccupancyScale {
  double resolution_m = 0.05;        ///< side of a pixel
  Pose2 world_from_picture;          ///< of the picture's lower left corner
  bool negate = false;               ///< true: white is occupied
  double occupied_threshold = 0.65;  ///< darker is an obstacle
  double free_threshold = 0.196;     ///< below the 0.1961 of the usual grey (205) for unknown
};

/// A world from a picture and, where given, a picture of the same size with the number of the room
/// for each pixel (0: none).
///
/// Walls are the occupied cells, and the unknown ones that touch a free cell, side or corner: a
/// robot must not leave what is known. Beyond the picture all is unknown. Rooms are the labels,
/// spread over free cells without a label for at most 0.3 m (label pictures leave lines between
/// rooms and along walls). Doors are the lines of 0.3 m and more on which two labels touch; their
/// openings are empty, for such a line has no thickness. What was assumed is in `issues`.
/// Throws InputError when the sizes differ or nothing is free.
[[nodiscard]] FloorPlan world_of_occupancy(const Picture& picture, const OccupancyScale& scale,
                                           const std::optional<Picture>& labels,
                                           const std::string& name);

}  // namespace roomatlas::io
