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
/// Of several missions each is judged by itself too.
/// @param jobs threads at once, see `for_each_index`
/// @throws InputError where the store is not assembled, UsageError as `joined_paths`
[[nodiscard]] Evaluation evaluate_store(const AssemblyStore& store, Truth truth,
                                        const TrajectoryPreparation& preparation = {},
                                        int jobs = 1);

/// All missions of a building as one, and what is known of them.
struct JoinedPaths {
  std::vector<Trajectory> odometry;   ///< of each mission, begun where its corrected path begins
  std::vector<Trajectory> corrected;  ///< of each mission, building metres
  std::vector<double> later_s;  ///< added to each mission's times below, so that none are shared; 0
                                ///< where none were
  Trajectory all_odometry;
  Trajectory all_corrected;
  std::vector<Relation> relations;  ///< of all
  Trajectory poses;                 ///< of all
};

/// @param store of several missions, assembled
/// @throws UsageError where truth is of no one mission though the missions' times overlap (parts of
///   one recording may), or names a mission that is none or several of them
[[nodiscard]] JoinedPaths joined_paths(const AssemblyStore& store, const Truth& truth,
                                       const TrajectoryPreparation& preparation = {});

/// True poses that came with the mission.
[[nodiscard]] Trajectory true_poses_of(const AsrSource& source);

}  // namespace roomatlas
