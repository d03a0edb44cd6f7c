// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/plan/ids.hpp"

namespace roomatlas {

/// The outline of a room, or of one visit to it, placed in the building.
struct PlacedOutline {
  AsrId asr = 0;
  RoomId room = 0;
  Polygon outline;  ///< building metres; may self-intersect, repeat vertices, or be empty
};

}  // namespace roomatlas
