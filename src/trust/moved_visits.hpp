// SPDX-License-Identifier: GPL-3.0-or-later
// How far other solutions move and turn the visits of sonars.
#pragma once

#include <map>
#include <vector>

#include "roomatlas/assembly/assembly.hpp"

namespace roomatlas {

/// Root mean squares over the solutions.
struct MoveSize {
  double place_m = 0.0;
  double heading_rad = 0.0;
};

/// Of a map's visits together.
struct MapMoves {
  double place_m = 0.0;  ///< root mean square over visits, too
  MoveSize worst;        ///< of the visit that is moved, or turned, most in each solution
  double log_off = 0.0;  ///< mean logarithm of how many times as far as a map that is right may
                         ///< be off a solution is: 0.25 m in a visit, or 2 degrees
  std::map<AsrId, MoveSize> visits;
};

/// @param centres of the visits' paths in their frames, metres
/// @returns for no solution at all: 10 m and half a turn, as nothing is known
[[nodiscard]] MapMoves map_moves(const MovedVisits& moved, const std::map<AsrId, Point2>& centres);

}  // namespace roomatlas
