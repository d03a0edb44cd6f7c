// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "roomatlas/asr/recorder.hpp"
#include "roomatlas/correct/correct.hpp"
#include "roomatlas/draft/draft_building.hpp"
#include "roomatlas/edit/edit.hpp"
#include "roomatlas/graph/recognise.hpp"
#include "roomatlas/join/join_missions.hpp"
#include "roomatlas/locate/sonar_shape.hpp"
#include "roomatlas/loops/closures.hpp"
#include "roomatlas/loops/feed_back.hpp"
#include "roomatlas/match/kidnapping.hpp"
#include "roomatlas/match/room_localizer.hpp"
#include "roomatlas/merge/merge.hpp"
#include "roomatlas/merge/regular_walls.hpp"
#include "roomatlas/mission/mission.hpp"
#include "roomatlas/odometry/drive_directions.hpp"
#include "roomatlas/rooms/assign_rooms.hpp"
#include "roomatlas/sonar/sonar_trajectory.hpp"

namespace roomatlas {

/// How a mission becomes ASRs. A store's ASRs hang on these and on `MissionOptions` alone; the
/// offline stage takes the same where it maps rooms again.
struct MapOptions {
  DriveDirectionOptions directions;  ///< of drives: on the stream, and again for the whole of a
                                     ///< mission with sonars
  LocalizeOptions localize;
  KidnappingOptions kidnapping;  ///< where a mission is cut before it is mapped
  RecorderOptions record;
};

/// How the plan is drawn.
enum class PlanStyle {
  drafted,  ///< as an architect would: walls are inferred from all readings of the mission
  traced,   ///< the paper's: rooms are the outlines of their ASRs
};

/// How ASRs become a floor plan.
struct AssembleOptions {
  bool correct_sonars = true;  ///< a mission with sonars alone is corrected as a whole first, one
                               ///< with a laser where its map is doubtful; off: rooms of sonars as
                               ///< odometry bent them
  SonarTrajectoryOptions sonars;
  std::vector<std::string> missions;  ///< of several, by name or number: those that are drawn;
                                      ///< empty: all
  bool draw_latest = true;  ///< what changed between missions is drawn as the latest saw it; off:
                            ///< as all of them together did
  int answer =
      1;  ///< which of several that explain the readings about equally well, the best first
  bool match_rooms = true;  ///< match localized rooms by their walls; off: doorways alone
  ClosureOptions closures;
  RecogniseOptions recognise;
  PlanStyle plan = PlanStyle::drafted;
  DraftBuildingOptions draft;  ///< of a drafted plan
  RoomOptions rooms;           ///< of a traced plan: which ASRs are one room
  CorrectOptions correct;
  FeedBackOptions feed_back;
  bool regular_walls = true;  ///< also draw a traced plan's walls along the building's directions
  RegularWallOptions regular;
  double sonar_corner_m = 0.8;  ///< `regular.blind_corner_m` where sonars were heard
  MergeOptions merge;
  bool map_again = true;    ///< cut the rooms' outlines at doors that only later visits found
  int max_rounds = 5;       ///< of recognising doorways and correcting
  std::vector<Edit> edits;  ///< what somebody who knows the building says, see `with_places`
};

/// All options of all stages, each once.
struct Options {
  MissionOptions mission;
  MapOptions map;
  AssembleOptions assemble;
  JoinOptions join;
  SonarShapeOptions sonar_shapes;  ///< how visits of sonars are matched with those of others
  int jobs = 0;  ///< threads that work at once, see `thread_count`; 0: one for each core. More take
                 ///< more memory; the results are the same to the byte
};

}  // namespace roomatlas
