// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/core/learnt_sum.hpp"
#include "roomatlas/join/place_mission.hpp"
#include "roomatlas/locate/place_evidence.hpp"

namespace roomatlas {

/// A place is sure where it is right with so much. Of the queries that were given it when their
/// pair was left out of learning, all 858 of lasers were right, and 441 of 445 of sonars.
constexpr double kSurePlace = 0.92;

struct JudgePlacesOptions {
  PlaceEvidenceOptions evidence;
  double near_score = 25.0;  ///< places whose walls score so much less than the best are not asked
  double laser_nats = 0.03;  ///< a ray that agrees speaks so much for a place ...
  double sonar_nats = 0.2;   ///< ... a cone so much ...
  double contradiction = 1.25;  ///< ... and one that contradicts so many times that against it
  double cell_m = 0.5;  ///< what lies in one such cell counts as one where places are compared
};

/// What the visits of a mission saw, as `judge_places` asks for it.
[[nodiscard]] std::vector<AskedVisit> asked_visits(const MissionMap& mission);

/// Places of a few metres of path or of a whole mission, judged by walls, floor and single ranges.
struct JudgedPlaces {
  std::vector<MissionPlace> places;   ///< the likeliest first; scores with those of the rays
  std::vector<JudgedFigure> figures;  ///< of the first, and what speaks for it against the others
  double first_is_right = 0.0;        ///< probability
};

/// What walls alone leave open is decided by the rays, and what tells the first place from each of
/// the others says how sure it is. The weights were learnt (`./run bench locate train`).
/// @param places as `place_mission` found them; may be empty
/// @param asked the visits that are in their pieces
[[nodiscard]] JudgedPlaces judge_places(std::vector<MissionPlace> places,
                                        const std::vector<AskedVisit>& asked,
                                        const SeenBuilding& building, SensorKind sensor,
                                        const JudgePlacesOptions& options);

}  // namespace roomatlas
