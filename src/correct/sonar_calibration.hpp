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

}  // namespace roomatlas
