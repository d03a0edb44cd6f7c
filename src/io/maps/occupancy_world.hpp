// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pictures/picture.hpp"
#include "roomatlas/core/pose2.hpp"
#include "roomatlas/grid/map_cells.hpp"
#include "roomatlas/plan/floor_plan.hpp"

#include <optional>
#include <string>
#include <vector>

namespace roomatlas::io {

/// What a picture's greys mean; the words are those of a nav2 map file.
enum class MapMode {
  trinary,  ///< free, occupied or unknown, by two thresholds
  scale,    ///< transparent pixels are unknown, all others known: those between the thresholds are
            ///< what they are nearer to
  raw,      ///< the grey's number is the occupancy in per cent; above 100 unknown
};

/// How to read an occupancy picture; the words are those of a nav2 map file.
struct OccupancyScale {
  double resolution_m = 0.05;        ///< side of a pixel
  Pose2 world_from_picture;          ///< of the picture's lower left corner
  bool negate = false;               ///< true: white is occupied
  double occupied_threshold = 0.65;  ///< darker is an obstacle
  double free_threshold = 0.196;     ///< below the 0.1961 of the usual grey (205) for unknown
  MapMode mode = MapMode::trinary;
};

/// What a pixel of the picture says.
[[nodiscard]] MapCell cell_of(int value, int white, const OccupancyScale& scale);

/// Throws InputError where no cell is free.
void require_floor(const std::vector<MapCell>& cells, const std::string& name);

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
