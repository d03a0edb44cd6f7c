// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomatlas/asr/store.hpp"
#include "roomatlas/correct/correction.hpp"
#include "roomatlas/evaluate/mission_figures.hpp"
#include "roomatlas/evaluate/plan_alignment.hpp"
#include "roomatlas/evaluate/plan_errors.hpp"
#include "roomatlas/evaluate/relations.hpp"
#include "roomatlas/evaluate/room_pose_errors.hpp"
#include "roomatlas/evaluate/self_consistency.hpp"
#include "roomatlas/evaluate/spans.hpp"
#include "roomatlas/evaluate/true_poses.hpp"
#include "roomatlas/evaluate/wall_errors.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

/// What is known of one of several missions, in its own clock.
struct TruthOfMission {
  std::string mission;  ///< its name, the name without its endings, or its number from 1
  std::vector<Relation> relations;
  Trajectory poses;
};

/// What is known of the truth; everything is optional.
struct Truth {
  std::vector<Relation> relations;
  Trajectory poses;
  std::vector<TruthOfMission> missions;  ///< beside those above, which are of all
  std::optional<FloorPlan> plan;
  bool plan_has_doors = true;    ///< false for a plan from a label picture
  bool plan_is_of_poses = true;  ///< false for a plan in a frame of its own: laid on by its rooms
  std::vector<Span> spans;       ///< lengths measured in the building
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

/// One of several missions of a building against the truth.
struct MissionErrors {
  std::string name;
  std::optional<RelationsBeforeAfter> relations;  ///< those with both times in the mission
  std::optional<TruePosesBeforeAfter> true_poses;
  /// Laid on the truth as all missions together are, not by itself.
  Statistics in_building_m;
  Statistics in_building_deg;
};

/// What there is to say of several missions beyond their map.
struct MissionsEvaluation {
  MissionsFigures figures;
  std::vector<MissionErrors> errors;      ///< parallel to `figures.missions`
  std::optional<RelationErrors> between;  ///< relations from one mission to another
};

struct Evaluation {
  /// Of several missions; `relations` and `true_poses` are then of all together, and odometry of
  /// each begins where its corrected path begins.
  std::optional<MissionsEvaluation> missions;
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
/// @param jobs threads at once, see `for_each_index`
void judge_placements(const AsrSource& source, const Correction& correction, const FloorPlan& plan,
                      const Truth& truth, Evaluation& evaluation, int jobs = 1);

}  // namespace roomatlas
