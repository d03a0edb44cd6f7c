// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/evaluate/plan_graph.hpp"
#include "roomatlas/plan/floor_plan.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace roomatlas {

struct RoomMatch {
  RoomId room = 0;
  RoomId true_room = 0;
  double iou = 0.0;  ///< intersection over union of the areas, [0, 1]
};

struct DoorMatch {
  std::int64_t door = 0;
  std::int64_t true_door = 0;
  double distance_m = 0.0;     ///< between mid-points
  double width_error_m = 0.0;  ///< distance of its jambs less that of the true door's
};

/// Counting found things as right: [0, 1] each; 0 where there is nothing to divide by.
struct DetectionScore {
  std::int64_t matched = 0;
  double precision = 0.0;  ///< of what was found, the share that is true
  double recall = 0.0;     ///< of what is true, the share that was found
  double f1 = 0.0;
};

/// How the area of the true rooms is divided among the found ones. Shares are in [0, 1].
struct Segmentation {
  /// Mean over the true rooms of the share that the found room with most of it covers (recall of
  /// Bormann et al., "Room segmentation: survey, implementation, and analysis", ICRA 2016).
  double area_recall = 0.0;
  /// Mean over the found rooms of their share in the true room that has most of them (precision of
  /// the same survey).
  double area_precision = 0.0;
  /// Mean over the true rooms of the Matthews correlation of "inside the true room" with "inside
  /// its matched room" (after Mielle et al., "A method to segment maps from different modalities
  /// using free space layout", ICRA 2018). Area is counted over all rooms of both plans together;
  /// a true room without a pair counts 0. [-1, 1]; 1 is perfect.
  double matthews = 0.0;
  double unlabelled = 0.0;  ///< share of the true rooms' area that is in no found room
  double invented = 0.0;    ///< share of the found rooms' area that is in no true room
  /// Share of the true rooms' labelled area outside of the largest piece of each: 0 where every
  /// true room lies in one found room.
  double over_segmentation = 0.0;
  /// Share of the found rooms' true area outside of the largest true room of each: 0 where every
  /// found room lies in one true room.
  double under_segmentation = 0.0;
  std::vector<RoomId> split_true_rooms;  ///< with two or more found rooms that matter in them
  std::vector<RoomId> merged_rooms;      ///< found rooms with two or more true rooms in them
};

struct PlanErrors {
  std::int64_t rooms = 0;
  std::int64_t true_rooms = 0;
  double precision = 0.0;  ///< of rooms at the IoU threshold
  double recall = 0.0;
  double f1 = 0.0;
  double mean_iou = 0.0;                ///< over matched rooms
  DetectionScore strict;                ///< rooms at the strict IoU threshold
  double mean_true_iou = 0.0;           ///< over all true rooms; without a pair 0
  std::vector<RoomMatch> room_matches;  ///< one to one, IoU at or over the threshold, best first
  std::vector<RoomMatch> room_pairs;    ///< one to one, any overlap, best first
  Segmentation segmentation;

  bool doors_known = true;  ///< false: the truth has no doors, and the rest was not measured
  std::int64_t doors = 0;
  std::int64_t true_doors = 0;
  DetectionScore door_score;
  double mean_door_distance_m = std::numeric_limits<double>::quiet_NaN();  ///< of matched doors
  /// Mean over matched doors of the width error without its sign.
  double mean_door_width_error_m = std::numeric_limits<double>::quiet_NaN();
  std::vector<DoorMatch> door_matches;          ///< one to one, within the gate, nearest first
  std::vector<std::int64_t> used_true_doors;    ///< true doors that the true path went through
  std::vector<std::int64_t> missed_used_doors;  ///< of those, the ones without a match
  std::optional<PlanGraphErrors> graph;         ///< where doors are known
};

struct PlanErrorOptions {
  double iou_threshold = 0.5;          ///< rooms that overlap less are not the same
  double strict_iou_threshold = 0.75;  ///< the same, for the stricter precision and recall
  double door_gate_m = 0.5;            ///< doors farther apart than this are not the same
  double piece_share = 0.2;            ///< a piece of a room this large makes it split or merged
  bool doors_known = true;             ///< false for a truth that shows no doors
};

/// Compares a plan with the true plan. Rooms are assigned one to one such that most pairs reach the
/// IoU threshold and, among those, the sum of all IoU is greatest (exact). Doors are matched one to
/// one, as many as lie within the gate, with the least sum of distances between mid-points (exact).
/// An empty plan scores 0.
/// @param truth_from_building alignment, as `align_plan` or `true_pose_errors` give it
/// @param true_path the robot's true path, for the doors that it used; may be empty
[[nodiscard]] PlanErrors plan_errors(const FloorPlan& plan, const FloorPlan& truth,
                                     const Pose2& truth_from_building, const Trajectory& true_path,
                                     const PlanErrorOptions& options);

}  // namespace roomatlas
