// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "roomatlas/asr/asr.hpp"

namespace roomatlas {

struct WallDirectionOptions {
  double min_edge_m = 0.4;         ///< shorter edges say little about direction
  double min_total_m = 3.0;        ///< less wall than this gives no direction
  double min_aligned_share = 0.5;  ///< of the wall's length within 6 degrees; below, the room is
                                   ///< not rectilinear and must not be bent into it
};

/// The direction that a room's walls share, modulo 90 degrees.
struct WallDirection {
  double angle_rad = 0.0;      ///< in the ASR's frame, [0, pi/2)
  double aligned_share = 0.0;  ///< of the length of wall, (0, 1]
  double aligned_m = 0.0;      ///< length of wall that follows it
};

/// The direction that most of a room's walls follow, modulo 90 degrees, weighted by length.
/// Nothing where there is too little wall, or the room is not rectilinear.
[[nodiscard]] std::optional<WallDirection> wall_direction(const std::vector<WallPolyline>& walls,
                                                          const WallDirectionOptions& options);

/// The direction near `about_rad` that most wall follows, over rooms that are placed: the mean of
/// the edges' directions in a window that shrinks from 6 to 1.5 degrees, so that wings at a small
/// angle and curves do not draw it aside.
/// @param heading_rad of each room, parallel to `rooms`
[[nodiscard]] double settled_direction(double about_rad, const std::vector<const Asr*>& rooms,
                                       const std::vector<double>& heading_rad,
                                       const WallDirectionOptions& options);

}  // namespace roomatlas
