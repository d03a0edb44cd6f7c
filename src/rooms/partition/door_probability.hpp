// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "piece_openings.hpp"

namespace roomatlas {

/// A part of the floor while pieces are being joined.
struct Region {
  double area_m2 = 0.0;
  double radius_m = 0.0;  ///< of the largest circle in one of its pieces
  Ring hull;              ///< convex, counter-clockwise
  double hull_m2 = 0.0;
};

constexpr std::size_t kDoorFigures = 10;
/// What the probability of a door is made of, in the order of the weights.
using DoorFigures = std::array<double, kDoorFigures>;

/// The figures of the openings between two regions; there is at least one.
/// @param smaller the region with less area
[[nodiscard]] DoorFigures door_figures(const Region& smaller, const Region& larger,
                                       const std::vector<const PieceOpening*>& openings);

/// A logistic model: the probability is 1 / (1 + exp(-(bias + weights . figures))).
struct DoorWeights {
  double bias = 0.0;
  DoorFigures weights{};
};

/// Learned from 13 labelled maps, with furniture and without, as they are, turned and at half
/// resolution: `./run bench rooms train`.
[[nodiscard]] DoorWeights learned_door_weights();

/// What speaks against a door since the robot drove through, [0, 1]: nothing at a door's width, for
/// doors are there to be driven through; 1 where it is much wider than a robot needs.
[[nodiscard]] double driven_wide(const std::vector<const PieceOpening*>& openings);

/// @param driven_wide lowers the probability; not learned, for the maps learned from have no paths
[[nodiscard]] double door_probability(const DoorFigures& figures, const DoorWeights& model,
                                      double driven_wide = 0.0);

}  // namespace roomatlas
