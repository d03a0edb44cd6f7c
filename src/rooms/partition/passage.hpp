// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "open_floor.hpp"

namespace roomatlas {

/// Whether the walls beside an opening go on straight through it, on its two sides: the share of
/// lines parallel to it, 0.5 to 2.5 m off, that end where its jambs stand; of both jambs the lesser
/// share. A cut across a corridor has much on both sides, whatever doors lie beside it, the mouth
/// of a corridor on one, and a door on none.
struct Passage {
  double less = 0.0;  ///< [0, 1]
  double more = 0.0;
  /// On the side with less: the logarithm of the largest clearance within 3 m straight on over the
  /// opening's, [0, 1.2]. About 0.2 where corridors meet, 0.7 and more where a hall begins.
  double rise = 0.0;
};

/// Whether it is a cut across a corridor, whose walls go on straight on both sides.
[[nodiscard]] bool is_across_corridor(const Passage& passage);

/// 0 on a side where the floor ends at once.
[[nodiscard]] Passage passage_at(const OpenFloor& floor, const Segment2& jambs);

}  // namespace roomatlas
