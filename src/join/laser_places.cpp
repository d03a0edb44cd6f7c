// SPDX-License-Identifier: GPL-3.0-or-later
// Printed by `bench_locate train laser`, from 1367 queries of 62 pairs, 915 of them right.
#include "learnt_places.hpp"

namespace roomatlas {

const LearntSum& laser_place_is_right() {
  static constexpr LearntTerm kTerms[] = {
      {"walls and floor that contradict", -3.689, 1.612, -0.7566},
      {"walls where nothing is known", -4.592, 2.287, -0.3349},
      {"score", 3.49, 1.589, 2.962},
      {"contradicting rays to agreeing ones", -3.836, 1.618, -0.9677},
      {"margin to the next place", 2.632, 1.219, 2.377},
      {"votes against the closest rival", 3.881, 2.907, 0.5368},
  };
  static const LearntSum kSum{1.637, kTerms};
  return kSum;
}

}  // namespace roomatlas
