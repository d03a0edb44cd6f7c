// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "open_floor.hpp"

namespace roomatlas {

/// How much of the line beyond a jamb looks like a wall that ends there; shares, [0, 1].
struct WallSupport {
  double near = 0.0;    ///< of the first 0.5 m
  double middle = 0.0;  ///< of 1.5 m
  double far = 0.0;     ///< of 2.5 m
};

/// A sample beyond the jamb looks like a wall when an obstacle lies within 0.1 m of the line and
/// open floor beside it within 0.4 m: the middle of a block is none, and neither is open floor.
/// @param along unit vector away from the opening
[[nodiscard]] WallSupport wall_support(const OpenFloor& floor, const Point2& jamb,
                                       const Point2& along);

}  // namespace roomatlas
