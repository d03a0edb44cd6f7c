// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "roomatlas/asr/recorder.hpp"
#include "roomatlas/correct/correct.hpp"
#include "roomatlas/correct/sonar_trajectory.hpp"
#include "roomatlas/evaluate/evaluate.hpp"
#include "roomatlas/evaluate/plan_alignment.hpp"
#include "roomatlas/evaluate/room_pose_errors.hpp"
#include "roomatlas/evaluate/self_consistency.hpp"
#include "roomatlas/evaluate/spans.hpp"
#include "roomatlas/evaluate/wall_errors.hpp"
#include "roomatlas/graph/closures.hpp"
#include "roomatlas/graph/doors.hpp"
#include "roomatlas/graph/recognise.hpp"
#include "roomatlas/graph/segment_rooms.hpp"
#include "roomatlas/match/dead_reckoner.hpp"
#include "roomatlas/merge/merge.hpp"
#include "roomatlas/merge/regular_walls.hpp"
#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

struct MapOptions {
  DeadReckonerOptions reckon;
  LocalizeOptions localize;
  RecorderOptions record;
};

/// What the online stage saw.
struct MapSummary {
  std::int64_t asrs = 0;
  std::int64_t wall_vertices = 0;
  int intervals_reversed = 0;  ///< drives between stops that odometry reported the wrong way round
  std::optional<OdometryHabits> habits;  ///< of odometry, learnt and taken out by the way (laser)
};

/// Online stage: a mission's events become ASRs in the sink, room by room.
/// @throws NotEnoughError when there are no range readings, no odometry, or no wall was seen (what
///   was mapped by then is in the sink), Interrupted when `progress` says so (the room being
///   mapped has been handed over)
[[nodiscard]] MapSummary map_mission(MissionSource& mission, AsrSink& sink,
                                     const MapOptions& options, const Progress& progress = {});

/// How readings are matched once more where the correction puts them.
struct FeedBackOptions {
  bool enabled = true;
  ScanOptions scan;
  AlignOptions align{.first_gate_m = 0.12, .max_iterations = 4};
  int max_points = 120;            ///< of a sweep
  double min_face_hits = 12.0;     ///< in one visit; fewer lie where noise put them
  double position_sigma_m = 0.05;  ///< of the pose in its own ASR ...
  double heading_sigma_rad = radians(2.0);
  int min_matched = 20;            ///< fewer partners: the pose stays
  double min_matched_share = 0.3;  ///< so it does below this share of the sweep
};

struct AssembleOptions {
  bool correct_sonars = true;  ///< a mission with sonars alone is corrected as a whole first; off:
                               ///< its rooms as odometry bent them
  SonarTrajectoryOptions sonars;
  bool match_rooms = true;  ///< match localized rooms by their walls; off: doorways alone
  ClosureOptions closures;
  RecogniseOptions recognise;
  RoomOptions rooms;       ///< where rooms are decided by the ASRs' outlines
  SegmentOptions segment;  ///< where they are decided by everything that the mission saw
  CorrectOptions correct;
  FeedBackOptions feed_back;
  bool regular_walls = true;  ///< also draw walls along the building's directions
  RegularWallOptions regular;
  double sonar_corner_m = 0.8;  ///< `regular.blind_corner_m` where sonars were heard
  MergeOptions merge;
  RecorderOptions record;  ///< for mapping rooms again once more is known
  bool map_again = true;   ///< cut the rooms' outlines at doors that only later visits found
  int max_rounds = 5;      ///< of recognising doorways and correcting
};

/// Everything that the offline stage finds.
struct Assembly {
  RoomGraph graph;
  Correction correction;
  std::map<AsrId, RoomId> room_of_asr;
  std::vector<BuildingDoor> doors;
  std::optional<SonarTrajectory> sonars;  ///< how a sonar mission was corrected; poses left out
  std::vector<Asr> mapped_again;  ///< instead of the source's ASRs, where these were recorded anew
  Paths paths;                    ///< instead of the source's, where readings were matched again;
                                  ///< see `WithPaths`
  std::vector<Closure> closures;  ///< matches of rooms by their walls, accepted or not
  FloorPlan plan;
  std::optional<FloorPlan> measured_plan;  ///< as measured, where the walls of `plan` are regular
};

/// Offline stage: ASRs -> room graph -> correction -> floor plan.
/// @throws NotEnoughError when the source holds no ASR
[[nodiscard]] Assembly assemble(const AsrSource& source, const RobotFootprint& footprint,
                                const AssembleOptions& options, const Progress& progress = {});

/// A mission's paths and walls, where odometry alone and where the correction puts them.
struct PlacedMission {
  Trajectory odometry;                 ///< as in the log, one pose a reading
  Trajectory corrected;                ///< building metres, parallel to `odometry`
  Polyline path_before;                ///< odometry's path, building metres
  std::vector<Polyline> walls_before;  ///< building metres
  std::vector<Polyline> walls_after;
};
[[nodiscard]] PlacedMission place(const AsrSource& source, const Correction& correction);

/// The room graph as the correction left it: what was driven, and the doorways it recognised.
[[nodiscard]] RoomGraph graph_of(const AsrSource& source, const Correction& correction);

/// What is known of the truth; everything is optional.
struct Truth {
  std::vector<Relation> relations;
  Trajectory poses;
  std::optional<FloorPlan> plan;
  bool plan_has_doors = true;  ///< false for a plan from a label picture
  std::vector<Span> spans;     ///< lengths measured in the building
};

struct RelationsBeforeAfter {
  RelationErrors before;
  RelationErrors after;
};
struct TruePosesBeforeAfter {
  TruePoseErrors before;
  TruePoseErrors after;
};

struct RoomPosesBeforeAfter {
  RoomPoseErrors before;
  RoomPoseErrors after;
};

struct Evaluation {
  std::optional<RelationsBeforeAfter> relations;
  std::optional<TruePosesBeforeAfter> true_poses;
  std::optional<PlanErrors> plan;
  PlanAlignment plan_alignment;  ///< by true poses where there are some, else by the rooms
  std::optional<WallErrors> walls;
  std::optional<SpanErrors> spans;
  std::optional<RoomPosesBeforeAfter> room_poses;    ///< needs true poses
  std::optional<ConsistencyComparison> consistency;  ///< needs no truth
  Issues issues;
};

/// Judges a correction against what is known of the truth.
/// @param relations how relations are brought together with the trajectories
/// @param carry odometry that fills the trajectories' gaps there; may be null
[[nodiscard]] Evaluation evaluate(const Trajectory& odometry, const Trajectory& corrected,
                                  const FloorPlan& plan, const Truth& truth,
                                  const RelationOptions& relations = {},
                                  const Trajectory* carry = nullptr);

/// Judges where odometry and where the correction put the rooms: against true poses where there are
/// some, and against themselves. Adds to `evaluation`, which `evaluate` has made of the same truth.
void judge_placements(const AsrSource& source, const Correction& correction, const FloorPlan& plan,
                      const Truth& truth, Evaluation& evaluation);

}  // namespace roomatlas
