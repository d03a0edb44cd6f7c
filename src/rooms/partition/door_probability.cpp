// SPDX-License-Identifier: GPL-3.0-or-later
#include "door_probability.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr double kDoorM = 0.9;        // the usual width
constexpr double kClosetM2 = 3.0;     // smaller regions are hardly rooms
constexpr double kFlush = 5.0;        // larger: less widening is already a door's
constexpr double kMostExponent = 30;  // beyond, a probability is 0 or 1

/// Support by walls, averaged over openings by their width.
struct MeanSupport {
  double far_sum = 0.0;
  double near_higher = 0.0;
  double flush_both = 0.0;
  double flush_one = 0.0;
};

MeanSupport mean_support(const std::vector<const PieceOpening*>& openings, double widths_m) {
  MeanSupport mean;
  for (const PieceOpening* opening : openings) {
    const double share = opening->width_m / widths_m;
    mean.far_sum += share * (opening->lower.far + opening->higher.far);
    mean.near_higher += share * opening->higher.near;
    mean.flush_both += share * std::exp(-kFlush * opening->widening.more);
    mean.flush_one += share * std::exp(-kFlush * opening->widening.less);
  }
  return mean;
}

}  // namespace

DoorFigures door_figures(const Region& smaller, const Region&,
                         const std::vector<const PieceOpening*>& openings) {
  double widths_m = 0.0;
  double widest_m = 0.0;
  for (const PieceOpening* opening : openings) {
    widths_m += opening->width_m;
    widest_m = std::max(widest_m, opening->width_m);
  }
  const MeanSupport support = mean_support(openings, widths_m);
  const double area = std::max(smaller.area_m2, 0.01);
  return {
      std::max(0.0, -std::log(widest_m / (2.0 * smaller.radius_m + 0.05))),
      support.far_sum * std::max(0.0, std::log(widest_m)),
      std::log(area / (smaller.radius_m * smaller.radius_m + 0.001)),
      std::log(widths_m / std::sqrt(area)),
      support.near_higher,
      1.0 / (1.0 + std::exp(3.0 * std::log(area / kClosetM2))),
      std::abs(std::log(widest_m / kDoorM)),
      std::min(1.1, area / std::max(0.05, smaller.hull_m2)),
      support.flush_both,
      support.flush_one,
  };
}

DoorWeights learned_door_weights() {
  return {-6.900, {1.762, -1.099, -1.461, -0.856, 7.770, -2.368, -1.600, 4.348}};
}

double door_probability(const DoorFigures& figures, const DoorWeights& model) {
  double exponent = model.bias;
  for (std::size_t i = 0; i < kDoorFigures; ++i) exponent += model.weights[i] * figures[i];
  return 1.0 / (1.0 + std::exp(-std::clamp(exponent, -kMostExponent, kMostExponent)));
}

}  // namespace roomatlas
