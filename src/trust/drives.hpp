// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/assembly/assembly.hpp"
#include "roomatlas/correct/correct.hpp"
#include "roomatlas/solve/added_edges.hpp"

namespace roomatlas {

/// A drive that could be made, and what it would measure.
struct Drive {
  Advice advice;  ///< what it is; its effect is not filled in
  PoseEdge edge;  ///< between two visits that are there already
};

/// Drives that may help: once more through each passage that alone holds what is behind it, once
/// more along the last passages of the shortest way from a component's first visit to the ends of
/// its chains, and through doors between rooms that were not used. A drive tells the pose of its
/// end from its beginning: along a known way as surely as that is held now (a passage in which the
/// robot was lost as surely as any), through a new door as a passage of its length is measured. At
/// both ends it is tied to the visit there by walls seen again, as well as the accepted match of
/// rooms in the middle, without any as a doorway seen twice. Where walls' directions give headings,
/// a tie does not swing what follows.
/// @param held the visits' covariance; nodes are places in `assembly.graph.vertices`
/// @param variance_factor by which residuals enlarged what was measured
[[nodiscard]] std::vector<Drive> drives_of(const Assembly& assembly, const CorrectOptions& correct,
                                           const AddedEdges& held, double variance_factor);

}  // namespace roomatlas
