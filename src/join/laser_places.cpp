// SPDX-License-Identifier: GPL-3.0-or-later
// Printed by `bench_locate train laser`, from 1104 queries of 30 pairs, 747 of them right.
#include "learnt_places.hpp"

namespace roomatlas {

const LearntSum& laser_place_is_right() {
  static constexpr LearntTerm kTerms[] = {
      {"walls and floor that contradict", -3.514, 1.704, -0.7447},
      {"walls where nothing is known", -4.478, 2.233, -1.149},
      {"score", 3.388, 1.549, 1.119},
      {"margin to the next place", 2.427, 1.264, 1.814},
      {"votes against the closest rival", 3.206, 3.086, 1.005},
  };
  static const LearntSum kSum{1.55, kTerms};
  return kSum;
}

}  // namespace roomatlas
