// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/pipeline/evaluate_store.hpp"

#include <utility>

#include "evaluate_missions.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/correct/place.hpp"

namespace roomatlas {

Trajectory true_poses_of(const AsrSource& source) {
  Trajectory poses;
  for (const TruePose& pose : source.truth()) {
    poses.push_back({pose.timestamp_s, pose.world_from_robot});
  }
  return poses;
}

Evaluation evaluate_store(const AssemblyStore& store, Truth truth,
                          const TrajectoryPreparation& preparation, int jobs) {
  if (!store.members().empty()) return evaluate_missions(store, truth, preparation, jobs);
  if (!truth.missions.empty()) {
    throw UsageError("truth of mission " + truth.missions.front().mission +
                     ": the store is of one mission; leave the name out");
  }
  if (truth.poses.empty()) truth.poses = true_poses_of(store);
  const auto prepared = [&](const char* name, Trajectory trajectory) {
    return preparation.prepare ? preparation.prepare(name, std::move(trajectory)) : trajectory;
  };
  const Correction correction = store.correction();
  const FloorPlan plan = store.plan();
  PlacedMission placed = place(store, correction);
  Evaluation evaluation = evaluate(prepared("odometry", std::move(placed.odometry)),
                                   prepared("corrected", std::move(placed.corrected)), plan, truth,
                                   preparation.relations, preparation.carry);
  judge_placements(store, correction, plan, truth, evaluation, jobs);
  return evaluation;
}

}  // namespace roomatlas
