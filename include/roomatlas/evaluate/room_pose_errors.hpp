// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/evaluate/evaluate.hpp"

#include <cstdint>
#include <vector>

namespace roomatlas {

/// The robot's path through one ASR, where a placement puts it.
struct PlacedVisit {
  AsrId asr = 0;
  RoomId room = 0;
  Trajectory path;  ///< building metres, in the order of the mission
};

/// How far a room is from its true place: the mean over its visits, each counted by its poses.
struct RoomPoseError {
  RoomId room = 0;
  int visits = 0;              ///< with true poses
  std::int64_t poses = 0;      ///< with a true pose
  double rotation_rad = 0.0;   ///< mean over the visits of |mean heading error| after alignment
  double translation_m = 0.0;  ///< mean over the visits of |mean position error| after alignment
  double relative_rotation_rad = 0.0;  ///< the same, aligned at the first visit instead
  double relative_translation_m = 0.0;
};

struct RoomPoseErrors {
  std::vector<RoomPoseError> rooms;  ///< ascending by id
  Statistics rotation_deg;           ///< over the rooms, each once
  Statistics translation_m;
  Statistics relative_rotation_deg;
  Statistics relative_translation_m;
};

/// The rotation and translation error of each room, from where the robot truly was inside it. A
/// visit's heading error is the mean over its poses, so that it says how the ASR is placed, and
/// hardly how the path bends inside it. Visits without true poses are left out; without any the
/// result is empty.
/// @param truth true poses in file order; interpolated between neighbours
/// @param truth_from_building the alignment of the whole, as `true_pose_errors` gives it
[[nodiscard]] RoomPoseErrors room_pose_errors(const std::vector<PlacedVisit>& visits,
                                              const Trajectory& truth,
                                              const Pose2& truth_from_building);

}  // namespace roomatlas
