// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "driven_path.hpp"
#include "mission_heading.hpp"

namespace roomatlas {

/// Mission, segments and chain under one set of odometry's habits.
struct HeadingProblem {
  DrivenPath path;
  std::vector<WallSegment> segments;
  std::vector<std::size_t> node_readings;
  std::vector<HeadingNode> nodes;
  std::vector<WallSighting> sightings;
};

/// Of log evidence, that another direction of the building or more doubt must bring; less is found
/// in noise.
constexpr double kClearly = 10.0;

struct Calibration {
  OdometryHabits habits;
  double doubt = 1.0;  ///< times the drift of odometry's heading that the chain allows, [1, inf)

  /// The chain's options with the drift that this mission's odometry has.
  [[nodiscard]] SightingChainOptions doubting(SightingChainOptions chain) const {
    chain.odometry.heading.per_sqrt_m *= doubt;
    chain.odometry.heading.per_rad *= doubt;
    return chain;
  }
};

/// @param jobs here and below: threads at once, see `for_each_index`
[[nodiscard]] HeadingProblem heading_problem(std::span<const RangeReading> readings,
                                             const DriveDirections& directions,
                                             const OdometryHabits& habits,
                                             const WallSegmentOptions& segments, int jobs);

/// The habits, and the doubt in what is left, under which the walls say most for one heading:
/// coordinate by coordinate over a coarse grid, then finer.
[[nodiscard]] Calibration calibrate_odometry(std::span<const RangeReading> readings,
                                             const DriveDirections& directions,
                                             const WallSegmentOptions& segments,
                                             const SightingChainOptions& chain, int jobs);

/// The directions, modulo 90 degrees, that the building's walls follow: 0, and others as long as
/// each makes the walls clearly more likely. A wing at an angle is one of them; without it, the
/// heading would be bent to make the wing's walls follow the rest.
/// @param clearly of log evidence, that each of the others must bring
[[nodiscard]] std::vector<double> building_directions(const HeadingProblem& problem,
                                                      SightingChainOptions chain, double clearly,
                                                      int jobs);

}  // namespace roomatlas
