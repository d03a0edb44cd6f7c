// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/merge/floor_plan.hpp"

#include <cstdint>
#include <vector>

namespace roomatlas {

struct RoomMatch {
  RoomId room = 0;
  RoomId true_room = 0;
  double iou = 0.0;
};

struct DoorMatch {
  std::int64_t door = 0;
  std::int64_t true_door = 0;
  double distance_m = 0.0;
};

struct PlanErrors {
  std::int64_t rooms = 0;
  std::int64_t true_rooms = 0;
  double precision = 0.0;  ///< of rooms at the IoU threshold
  double recall = 0.0;
  double f1 = 0.0;
  double mean_iou = 0.0;                        ///< over matched rooms
  std::vector<RoomMatch> room_matches;          ///< one to one, IoU at or over the threshold
  std::vector<DoorMatch> door_matches;          ///< one to one, within the gate
  std::vector<std::int64_t> used_true_doors;    ///< true doors that the true path went through
  std::vector<std::int64_t> missed_used_doors;  ///< of those, the ones without a match
};

struct PlanErrorOptions {
  double iou_threshold = 0.5;
  double door_gate_m = 0.5;  ///< doors farther apart than this are not the same
};

/// Compares a plan with the true plan. Rooms are matched one to one, greatest IoU first, doors
/// one to one, nearest mid-points first.
/// @param truth_from_building alignment, as `true_pose_errors` gives it
/// @param true_path the robot's true path, for the doors that it used; may be empty
[[nodiscard]] PlanErrors plan_errors(const FloorPlan& plan, const FloorPlan& truth,
                                     const Pose2& truth_from_building, const Trajectory& true_path,
                                     const PlanErrorOptions& options);

}  // namespace roomatlas
