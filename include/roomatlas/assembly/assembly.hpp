// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "roomatlas/asr/store.hpp"
#include "roomatlas/correct/correction.hpp"
#include "roomatlas/graph/room_graph.hpp"
#include "roomatlas/loops/closures.hpp"
#include "roomatlas/plan/answers.hpp"
#include "roomatlas/plan/door.hpp"
#include "roomatlas/plan/floor_plan.hpp"
#include "roomatlas/plan/judgement.hpp"
#include "roomatlas/plan/seen_last.hpp"
#include "roomatlas/sonar/sonar_trajectory.hpp"

namespace roomatlas {

/// How visits lie in other solutions: of each visit its frame in every one, in its frame as it is.
using MovedVisits = std::map<AsrId, std::vector<Pose2>>;

/// By solutions of sonars: see `SonarTrajectory`.
struct VisitMoves {
  MovedVisits drawn;
  MovedVisits wild;
  MovedVisits undirected;
  MovedVisits cross_check;
};

/// Everything that the offline stage finds.
struct Assembly {
  RoomGraph graph;
  Correction correction;
  std::map<AsrId, RoomId> room_of_asr;
  std::vector<Door> doors;
  std::optional<SonarTrajectory> sonars;  ///< how a sonar mission was corrected; poses left out
  VisitMoves moves;                       ///< of that mission's visits; empty of all others
  std::vector<Asr> mapped_again;  ///< instead of the source's ASRs, where these were recorded anew
  Paths paths;                    ///< instead of the source's, where readings were matched again;
                                  ///< see `WithPaths`
  std::vector<Closure> closures;  ///< matches of rooms by their walls, accepted or not
  std::optional<double> doubted;  ///< probability of the map by matched rooms whose place this one
                                  ///< took, as it was corrected as a whole; (0, 1)
  std::optional<Judgement> judgement;  ///< how far it can be relied on; none without readings
  std::vector<SeenLast> seen_last;     ///< what changed between several missions, by time
  Answers answers;                     ///< which of several that the readings allow this is
  Placement other_answer;  ///< of the visits, in the answer that this is not; empty where there is
                           ///< none, and of sonars, whose visits it bends
  FloorPlan plan;
  std::vector<PlanRoom> absent_rooms;      ///< named ones of former assemblies that `plan` has not
  std::optional<FloorPlan> measured_plan;  ///< as measured, where the walls of `plan` are regular
};

}  // namespace roomatlas
