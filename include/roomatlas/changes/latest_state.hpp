// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "roomatlas/changes/find_changes.hpp"

namespace roomatlas {

/// A door that stood open in earlier missions and is shut now. What was seen before is kept beside:
/// it says that there is a door, where what is seen now looks like wall.
struct ShutDoor {
  Segment2 line;                                  ///< jamb to jamb
  std::vector<std::pair<Cell, CellCounts>> open;  ///< its cells as they were seen before
};

/// What missions with lasers in one building say together, each of them later than those before:
/// of what was altered the latest of them alone is heard.
struct LatestState {
  BuildingEvidence evidence;  ///< of all visits, without what holds no more
  VisitTimes times;
  std::vector<ShutDoor> shut;
};

/// Takes a later mission in. Hits and surfaces where something is gone hold no more, nor beams that
/// passed where something stands now: inside of what changed unless the new mission saw it as
/// before, and around it as far as the new mission contradicts.
/// @param changes between what `state` says and the later mission, in the frame of both
/// @param options `evidence.cell_m` is that of both
void take_in(const BuildingEvidence& later, const std::vector<Change>& changes,
             const ChangeOptions& options, LatestState& state);

/// The evidence that a plan of the state is drafted of: altered cells as the state has them, and no
/// path where something stands by now. Doors that are shut are gaps in their walls, as they were
/// seen when they stood open.
/// @param all what all visits said, as it was gathered: what was not altered stays bit by bit
[[nodiscard]] BuildingEvidence as_drafted(BuildingEvidence all, const LatestState& state,
                                          const ChangeOptions& options);

}  // namespace roomatlas
