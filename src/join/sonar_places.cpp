// SPDX-License-Identifier: GPL-3.0-or-later
// Printed by `bench_locate train sonar`, from 575 queries of 14 pairs, 360 of them right.
#include "learnt_places.hpp"

namespace roomatlas {

const LearntSum& sonar_place_is_right() {
  static constexpr LearntTerm kTerms[] = {
      {"walls and floor that contradict", -3.006, 1.069, -0.007713},
      {"walls where nothing is known", -4.852, 0.6694, -0.5836},
      {"score", 3.961, 0.6276, 1.124},
      {"rays that contradict", -3.485, 1.203, -1.604},
      {"rays that nothing is told", -1.598, 0.551, 0.4023},
      {"margin to the next place", 1.918, 1.248, 2.206},
      {"votes against the closest rival", 1.273, 1.726, 0.163},
  };
  static const LearntSum kSum{0.9681, kTerms};
  return kSum;
}

}  // namespace roomatlas
