// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/evaluation.hpp"

#include "roomatlas/evaluate/time_ranges.hpp"

namespace roomatlas {
namespace {

/// Where the true plan lies: by the trajectory where it has true poses, else by the rooms alone.
PlanAlignment alignment_of(const Evaluation& evaluation, const FloorPlan& plan,
                           const Truth& truth) {
  const bool has_poses = evaluation.true_poses && evaluation.true_poses->after.matched > 0;
  if (!has_poses || !truth.plan_is_of_poses) return align_plan(plan, *truth.plan, {});
  PlanAlignment alignment;
  alignment.truth_from_building = evaluation.true_poses->after.truth_from_building;
  alignment.by = AlignedBy::trajectory;
  return alignment;
}

}  // namespace

Evaluation evaluate(const Trajectory& odometry, const Trajectory& corrected, const FloorPlan& plan,
                    const Truth& truth, const RelationOptions& relations, const Trajectory* carry) {
  Evaluation evaluation;
  if (!truth.relations.empty()) {
    evaluation.relations = {relation_errors(odometry, truth.relations, relations, carry),
                            relation_errors(corrected, truth.relations, relations, carry)};
  }
  if (!truth.poses.empty()) {
    evaluation.true_poses = {true_pose_errors(odometry, truth.poses),
                             true_pose_errors(corrected, truth.poses)};
    if (evaluation.true_poses->after.position_m.count == 0) {
      evaluation.issues.push_back({Severity::warning, "", 0, "true poses",
                                   explain_mismatch(times_of(corrected), times_of(truth.poses))});
    }
  }
  if (!truth.spans.empty()) evaluation.spans = span_errors(plan, truth.spans);
  if (!truth.plan) return evaluation;
  evaluation.plan_alignment = alignment_of(evaluation, plan, truth);
  if (evaluation.plan_alignment.by == AlignedBy::nothing) {
    evaluation.issues.push_back(
        {Severity::warning, "", 0, "truth",
         "the plan cannot be laid on the true plan: there are no true poses "
         "at the times of the readings, and no room overlaps a true one"});
  }
  PlanErrorOptions options;
  options.doors_known = truth.plan_has_doors;
  evaluation.plan = plan_errors(plan, *truth.plan, evaluation.plan_alignment.truth_from_building,
                                truth.plan_is_of_poses ? truth.poses : Trajectory{}, options);
  evaluation.walls = wall_errors(plan, *truth.plan, evaluation.plan_alignment.truth_from_building,
                                 *evaluation.plan, {});
  return evaluation;
}

}  // namespace roomatlas
