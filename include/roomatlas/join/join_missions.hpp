// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/core/progress.hpp"
#include "roomatlas/join/judge_places.hpp"
#include "roomatlas/join/place_mission.hpp"

namespace roomatlas {

/// How sure a mission's own correction is of one visit against another: standard deviations.
struct OwnSigmas {
  double position_m = 0.0;
  double position_m_per_m = 0.0;  ///< and so much for each metre between the two
  double heading_deg = 0.0;
};

struct JoinOptions {
  PlaceMissionOptions place;
  JudgePlacesOptions judge;
  /// Where walls leave it open, since their score is low or furniture may have been moved: a
  /// laser's place that is taken has so much probability by readings too.
  double sure_by_readings = kSurePlace;
  MatchMapsOptions match;
  OwnSigmas laser{0.015, 0.004, 0.25};
  OwnSigmas sonar{0.03, 0.01, 0.6};
  double own_heading_deg = 0.5;  ///< of a visit of a mission whose measurements are known
  int own_neighbours = 3;        ///< earlier visits of a mission that each visit is held to
  double near_m = 3.0;  ///< visits whose paths come this near to each other are matched ...
  int max_matches = 3;  ///< ... the nearest of other missions, so many at most
  SearchWindow window{0.5, radians(2.5)};        ///< around where the mission was placed
  SearchWindow again_window{1.2, radians(4.0)};  ///< once all are placed: what a mission bent ...
  /// All are solved together when so large a share of the visits is new, or where matches of a new
  /// mission contradict each other; else it is moved alone, which costs what it costs.
  double solve_growth = 0.3;
  double search_growth_m2 = 5.0;  ///< who found no place is looked for again once so much more
                                  ///< floor and wall is known
  int rounds = 2;                 ///< ... is straightened in so many rounds ...
  int straightenings = 4;  ///< ... and again, so often at most, where good matches were thrown out
  int min_agreeing = 60;   ///< points on common walls, of lasers ...
  int min_agreeing_sonar = 30;  ///< ... and where one of the two is a sonars' visit
  double min_agreement = 0.65;  ///< of the points that can tell
  double robust_sigmas = 2.0;   ///< matches off by more lose weight (Cauchy)
};

/// What became of one mission.
struct JoinedMission {
  int component = 0;     ///< missions of one component lie in one frame; 0, 1 ...
  bool is_base = false;  ///< its frame is the component's
  PlaceVerdict verdict = PlaceVerdict::nothing_in_common;  ///< of the last search; of a base none
  MissionPlace best;  ///< of the last search; without pieces where nothing was found, and
                      ///< of a base that others joined
  double runner_up_score = 0.0;  ///< of the next place that is another; 0 without
  bool is_other_answer = false;  ///< the others bear out `MissionMap::other_answer`
};

struct JoinedMissions {
  std::vector<JoinedMission> missions;  ///< parallel to what was given
  Placement placement;                  ///< of every visit, in its component's frame
  std::vector<Closure> closures;        ///< tried between visits of different missions
};

/// Joins missions of one building of which nothing is known but themselves: each is looked for in
/// what is joined already, its visits are matched with those around, and the whole is solved anew;
/// matches that contradict the others are thrown out. A mission for which there is no place, or
/// two, stays a component of its own. Of a mission with two answers both are looked for, and the
/// other is taken where it alone finds a place, or a better one by the margin of two places.
/// @param missions visits' ids differ between all of them. Each is tried in this order: who wants
///   one result for every order sorts them first
/// @param workers threads, or several processes: each placing, and each match of two visits, is
///   shared among them, and one of them solves
/// @throws Interrupted
[[nodiscard]] JoinedMissions join_missions(const std::vector<MissionMap>& missions,
                                           const JoinOptions& options,
                                           const Progress& progress = {},
                                           const Workers& workers = {});

}  // namespace roomatlas
