// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "roomatlas/assembly/assembly_store.hpp"
#include "roomatlas/evaluate/evaluation.hpp"

namespace roomatlas {

/// How a store's trajectories are brought together with the truth.
struct TrajectoryPreparation {
  /// Stamps a trajectory anew, cuts it, fills its gaps; not set: it stays as it is.
  std::function<Trajectory(const std::string& name, Trajectory)> prepare;
  RelationOptions relations;
  const Trajectory* carry = nullptr;  ///< odometry that fills gaps between poses; may be null
};

/// Judges all that an assembly left: its trajectory and plan against the truth, and where it put
/// the rooms, against themselves too. Where `truth` has no poses, those of the store are taken.
/// @throws InputError where the store is not assembled
[[nodiscard]] Evaluation evaluate_store(const AssemblyStore& store, Truth truth,
                                        const TrajectoryPreparation& preparation = {});

/// True poses that came with the mission.
[[nodiscard]] Trajectory true_poses_of(const AsrSource& source);

}  // namespace roomatlas
