// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "roomatlas/assembly/member_mission.hpp"
#include "roomatlas/core/progress.hpp"
#include "roomatlas/draft/evidence.hpp"
#include "roomatlas/pipeline/options.hpp"
#include "roomatlas/plan/seen_last.hpp"

namespace roomatlas {

/// The visits of missions that were driven at one time.
struct VisitsOfTime {
  std::string mission;  ///< name of its log; of several "a.clf, b.clf"
  std::vector<AsrId> visits;
};

/// Puts missions into the order of when they were driven. Those whose times overlap or touch count
/// as one time.
/// @param asrs with their paths, ascending by id
/// @param left_out visits of missions that are not drawn
[[nodiscard]] std::vector<VisitsOfTime> in_order_of_time(const std::vector<Asr>& asrs,
                                                         const std::vector<MemberMission>& members,
                                                         const std::set<AsrId>& left_out);

/// A building as it was seen last.
struct LatestBuilding {
  BuildingEvidence evidence;
  std::vector<Segment2> shut_doors;  ///< jamb to jamb; gaps in the evidence
  std::vector<SeenLast> told;        ///< of each time at which something had changed
};

/// What missions with lasers say together, where later ones contradict earlier ones: of each the
/// readings are gathered, and what changed against all before it is found by `changes_between`.
/// Where nothing changed it is the sum of all readings.
/// @param source of the visits that are drawn, with readings
/// @param placement of its visits; all that is returned is in that frame
/// @param times of all its visits, or of none: then all are of one time
[[nodiscard]] LatestBuilding latest_building(const AsrSource& source, const Placement& placement,
                                             const std::vector<VisitsOfTime>& times,
                                             const RobotFootprint& footprint,
                                             const Options& options, const Progress& progress);

/// Hangs leaves into doors that are shut.
void shut(const std::vector<Segment2>& lines, std::vector<Door>& doors);

/// The same in another frame.
[[nodiscard]] std::vector<SeenLast> moved(std::vector<SeenLast> told, const Pose2& to_from_here);

}  // namespace roomatlas
