// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/asr/asr.hpp"

#include <cmath>

namespace roomatlas {

double path_length_m(const Asr& asr) {
  double sum = 0.0;
  for (std::size_t i = 1; i < asr.path.size(); ++i) {
    sum +=
        (asr.path[i].asr_from_robot.position() - asr.path[i - 1].asr_from_robot.position()).norm();
  }
  return sum;
}

Turning turning(const Asr& asr) {
  Turning sum;
  for (std::size_t i = 1; i < asr.path.size(); ++i) {
    const double turn =
        wrap_angle(asr.path[i].asr_from_robot.theta_rad - asr.path[i - 1].asr_from_robot.theta_rad);
    sum.absolute_rad += std::abs(turn);
    sum.signed_rad += turn;
  }
  return sum;
}

}  // namespace roomatlas
