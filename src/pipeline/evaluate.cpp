// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/pipeline/pipeline.hpp"

namespace roomatlas {

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
  }
  if (!truth.plan) return evaluation;
  if (!evaluation.true_poses || evaluation.true_poses->after.matched == 0) {
    evaluation.issues.push_back(
        {Severity::warning, "", 0, "truth",
         "the plan cannot be compared: it needs true poses (TRUEPOS in the log) to align with"});
    return evaluation;
  }
  evaluation.plan = plan_errors(plan, *truth.plan, evaluation.true_poses->after.truth_from_building,
                                truth.poses, {});
  return evaluation;
}

}  // namespace roomatlas
