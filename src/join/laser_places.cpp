// SPDX-License-Identifier: GPL-3.0-or-later
// Printed by `bench_locate train laser`, from 1421 queries of 39 pairs, 979 of them right.
#include "learnt_places.hpp"

namespace roomatlas {

const LearntSum& laser_place_is_right() {
  static constexpr LearntTerm kTerms[] = {
      {"walls and floor that contradict", -3.728, 1.67, -0.9237},
      {"walls where nothing is known", -4.71, 2.133, -1.305},
      {"score", 3.514, 1.499, 1.239},
      {"margin to the next place", 2.397, 1.286, 2.618},
      {"votes against the closest rival", 3.269, 2.998, 0.5615},
  };
  static const LearntSum kSum{2.272, kTerms};
  return kSum;
}

}  // namespace roomatlas
