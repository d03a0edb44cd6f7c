// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/assembly/assembly.hpp"
#include "roomatlas/correct/correct.hpp"
#include "roomatlas/solve/pose_graph.hpp"

namespace roomatlas {

/// A drive that could be made, and what it would measure.
struct Drive {
  Advice advice;                ///< what it is; its effect is not filled in
  std::vector<PoseEdge> edges;  ///< between visits that are there already
};

/// Drives that may help: once more through each passage that alone holds what is behind it, once
/// more along the last passages of the shortest way from a component's first visit to the ends of
/// its chains, and through doors between rooms that were not used. A drive is measured as odometry
/// or localization measured those before it, and is tied to the visits that it passes by the walls
/// that it sees again, as well as accepted matches of rooms are in the middle, without any as a
/// doorway seen twice.
/// @param variance_factor by which residuals enlarged what was measured
/// @returns edges between places in `assembly.graph.vertices`
[[nodiscard]] std::vector<Drive> drives_of(const Assembly& assembly, const CorrectOptions& correct,
                                           double variance_factor);

}  // namespace roomatlas
