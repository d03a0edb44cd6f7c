// SPDX-License-Identifier: GPL-3.0-or-later
#include "door_probability.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr double kDoorM = 0.9;         // the usual width
constexpr double kClosetM2 = 3.0;      // smaller regions are hardly rooms
constexpr double kClearPassage = 0.6;  // share of lines; doors take the rest of a corridor's walls
constexpr double kHallRise = 0.7;      // where corridors meet it is less
constexpr double kMostDoorM = 1.2;     // the path through what is no wider says nothing
constexpr double kWideM = 1.7;         // and from here on all that it can
constexpr double kDrivenWeight = 2.0;  // larger joins halls with what is driven to from them
constexpr double kMostExponent = 30;   // beyond, a probability is 0 or 1

/// Support by walls, averaged over openings by their width.
struct MeanSupport {
  double far_sum = 0.0;
  double near_higher = 0.0;
  double mouth = 0.0;     ///< of a corridor
  double junction = 0.0;  ///< of corridors
};

MeanSupport mean_support(const std::vector<const PieceOpening*>& openings, double widths_m) {
  MeanSupport mean;
  for (const PieceOpening* opening : openings) {
    const double share = opening->width_m / widths_m;
    mean.far_sum += share * (opening->lower.far + opening->higher.far);
    mean.near_higher += share * opening->higher.near;
    const double passage = std::min(1.0, opening->passage.more / kClearPassage);
    mean.mouth += share * passage;
    mean.junction += share * passage * std::max(0.0, 1.0 - opening->passage.rise / kHallRise);
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
      support.mouth,
      support.junction,

  };
}

DoorWeights learned_door_weights() {
  return {-4.851, {0.952, -0.659, -1.128, -1.029, 3.563, -1.578, -1.674, 6.824, -3.862, 0.324}};
}

double driven_wide(const std::vector<const PieceOpening*>& openings) {
  double most = 0.0;
  for (const PieceOpening* opening : openings) {
    if (opening->crossings == 0 || opening->is_known) continue;
    const double excess_m = opening->width_m - kMostDoorM;
    most = std::max(most, std::clamp(excess_m / (kWideM - kMostDoorM), 0.0, 1.0));
  }
  return most;
}

double door_probability(const DoorFigures& figures, const DoorWeights& model, double driven_wide) {
  double exponent = model.bias - kDrivenWeight * driven_wide;
  for (std::size_t i = 0; i < kDoorFigures; ++i) exponent += model.weights[i] * figures[i];
  return 1.0 / (1.0 + std::exp(-std::clamp(exponent, -kMostExponent, kMostExponent)));
}

}  // namespace roomatlas
