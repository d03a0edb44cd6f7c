// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "roomatlas/draw/draw.hpp"
#include "roomatlas/plan/change.hpp"

namespace roomatlas {

/// What a drawing of changes says of its two missions.
struct ComparedMissions {
  std::string before;       ///< name of the older mission's log
  std::string before_date;  ///< empty where it is not known
  std::string after;        ///< the same of the newer one
  std::string after_date;
};

/// The changes as architects mark alterations, on a sheet as `draw_plan` makes it: grey what stands
/// as it did, red and dashed what is gone, green what is new, paler and hatched what was not seen
/// again. Each change has its number, and is named below the drawing. Layers: before, after,
/// not-seen-again, gone, new, numbers, labels, notes, title.
/// @param after in the frame of `before`
[[nodiscard]] std::string draw_changes(const FloorPlan& before, const FloorPlan& after,
                                       const PlanChanges& changes, const ComparedMissions& missions,
                                       const DrawOptions& options);

}  // namespace roomatlas
