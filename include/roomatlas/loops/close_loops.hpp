// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "roomatlas/core/progress.hpp"
#include "roomatlas/correct/correct.hpp"
#include "roomatlas/loops/closures.hpp"

namespace roomatlas {

/// Another way to close the loops that the readings allow nearly as well.
struct SecondLoops {
  int visits = 0;           ///< that it puts elsewhere ...
  double farthest_m = 0.0;  ///< ... by so much at most
  double score_m = 0.0;     ///< of wall that speaks for it, seen in these visits
  double kept_m = 0.0;      ///< the same of the one kept
  Placement other;          ///< of the ASRs, in the one that is not taken
};

/// What a mission saw of its rooms, and how it drove between them. References, for one call.
struct DrivenRooms {
  const std::vector<Asr>& asrs;
  const std::vector<AsrShape>& shapes;  ///< parallel to `asrs`
  const RoomGraph& graph;               ///< of `asrs`, vertices in this order
};

/// Where matching rooms with each other leads.
struct ClosedLoops {
  std::vector<Closure> closures;  ///< all that were tried in the last round, accepted or not
  Placement placement;
  std::set<AsrId> lost_before;  ///< on the way into these the robot was lost, their closures say
  std::optional<SecondLoops> second;
};

/// Matches rooms by their walls, within the uncertainty between them. First in the order of the
/// mission, so that each closure found narrows the search for the next; then all pairs that came
/// to lie near to each other again, in rounds.
/// @throws Interrupted
/// @param jobs threads at once, see `for_each_index`
[[nodiscard]] ClosedLoops close_loops(const DrivenRooms& rooms, const CorrectOptions& correct,
                                      const ClosureOptions& options, const Progress& progress = {},
                                      int jobs = 1);

}  // namespace roomatlas
