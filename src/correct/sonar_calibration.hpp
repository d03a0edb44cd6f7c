// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "driven_path.hpp"
#include "heading_chain.hpp"

namespace roomatlas {

/// Mission, segments and chain under one set of odometry's habits.
struct HeadingProblem {
  DrivenPath path;
  std::vector<WallSegment> segments;
  std::vector<std::size_t> node_readings;
  std::vector<HeadingNode> nodes;
  std::vector<WallSighting> sightings;
};

[[nodiscard]] HeadingProblem heading_problem(std::span<const RangeReading> readings,
                                             const DriveDirections& directions,
                                             const OdometryHabits& habits,
                                             const WallSegmentOptions& segments);

/// The habits under which the walls say most for one heading: coordinate by coordinate over a
/// coarse grid, then finer.
[[nodiscard]] OdometryHabits calibrate_odometry(std::span<const RangeReading> readings,
                                                const DriveDirections& directions,
                                                const WallSegmentOptions& segments,
                                                const HeadingChainOptions& chain);

/// The directions, modulo 90 degrees, that the building's walls follow: 0, and others as long as
/// each makes the walls clearly more likely. A wing at an angle is one of them; without it, the
/// heading would be bent to make the wing's walls follow the rest.
[[nodiscard]] std::vector<double> building_directions(const HeadingProblem& problem,
                                                      HeadingChainOptions chain);

}  // namespace roomatlas
