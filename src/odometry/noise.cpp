// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/odometry/noise.hpp"

#include <cmath>

namespace roomatlas {

double plain_sum(const MotionSigma& sigma, double way_m, double turn_rad) {
  return sigma.still + sigma.per_m * way_m + sigma.per_sqrt_m * std::sqrt(way_m) +
         sigma.per_rad * turn_rad;
}

double sum_of_squares(const MotionSigma& sigma, double way_m, double turn_rad) {
  const double by_way = sigma.per_m * way_m;
  const double by_turn = sigma.per_rad * turn_rad;
  return sigma.per_sqrt_m * sigma.per_sqrt_m * way_m + by_turn * by_turn +
         sigma.still * sigma.still + by_way * by_way;
}

}  // namespace roomatlas
