// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "altered_cells.hpp"
#include "roomatlas/grid/raster.hpp"

namespace roomatlas::changes {

/// A group of cells, and what the mission's readings say of it.
struct Witness {
  int hits = 0;    ///< readings of which a beam ended in it
  int passes = 0;  ///< readings of which a beam went through and on, and none ended in it
  std::vector<AsrId> visits;  ///< whose readings these are, ascending
  double first_s = 0.0;
  double last_s = 0.0;
  double lasting_s = 0.0;  ///< the median over its cells of the time from first hit to last
};

/// The visits that can have seen something of the groups: those that were near enough; ascending.
[[nodiscard]] std::vector<AsrId> visits_near(const BuildingEvidence& evidence,
                                             const std::vector<CellGroup>& groups,
                                             const GatherOptions& options);

/// Asks all readings of some visits of a mission about groups of cells.
/// @param groups disjoint
/// @returns one witness a group
[[nodiscard]] std::vector<Witness> ask(const AssembledMission& mission,
                                       const std::vector<AsrId>& ids,
                                       const std::vector<CellGroup>& groups,
                                       const GatherOptions& options, const Progress& progress,
                                       int jobs);

}  // namespace roomatlas::changes
