// SPDX-License-Identifier: GPL-3.0-or-later
// Headings of single nodes, from single returns.
#pragma once

#include <span>
#include <vector>

#include "sonar_problem.hpp"

namespace roomatlas {

/// Turns the nodes of a solved batch so that what each of their readings heard on the edges of its
/// cones agrees with the walls. Stretches of wall give the heading where they were heard;
/// between them, and before the first, it is odometry's otherwise. Positions stay.
/// @param map_from_robot, map_from_node as solved
/// @param options of the batch: how sure its headings are
/// @param jobs threads at once, see `for_each_index`
[[nodiscard]] std::vector<Pose2> with_headings_of_returns(std::span<const RangeReading> readings,
                                                          const SonarProblem& problem,
                                                          std::span<const Pose2> map_from_robot,
                                                          std::vector<Pose2> map_from_node,
                                                          const SonarBatchOptions& options,
                                                          int jobs = 1);

}  // namespace roomatlas
