// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "open_floor.hpp"

namespace roomatlas {

/// How much wider the floor is on the two sides of an opening: the natural logarithm of its width
/// along the jambs' line, 0.5 to 1.5 m off it, over the opening's; medians, [0, 1.2]. A cut across
/// a corridor has 0 on both sides, the mouth of a corridor on one, and a door on none.
struct Widening {
  double less = 0.0;
  double more = 0.0;
};

/// 0 on a side where the floor ends at once.
[[nodiscard]] Widening widening(const OpenFloor& floor, const Segment2& jambs);

}  // namespace roomatlas
