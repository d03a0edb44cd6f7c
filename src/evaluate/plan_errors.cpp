// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/plan_errors.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "detection_score.hpp"
#include "room_shapes.hpp"
#include "roomatlas/core/geometry.hpp"
#include "roomatlas/evaluate/assignment.hpp"
#include "segmentation.hpp"

namespace roomatlas {
namespace {

using IndexPairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// Pairs at the threshold come first, because one of them outweighs the IoU of all others.
IndexPairs pair_rooms(const Overlaps& overlaps, double iou_threshold) {
  const auto bonus = static_cast<double>(overlaps.rooms.size() + 1);
  WeightTable weights;
  for (std::size_t i = 0; i < overlaps.rooms.size(); ++i) {
    std::vector<double>& row = weights.emplace_back();
    for (std::size_t j = 0; j < overlaps.true_rooms.size(); ++j) {
      const double iou = overlaps.iou(i, j);
      row.push_back(iou > 0.0 && iou >= iou_threshold ? iou + bonus : iou);
    }
  }
  IndexPairs pairs;
  const auto columns = best_assignment(weights);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i]) pairs.emplace_back(i, *columns[i]);
  }
  return pairs;
}

void score_rooms(PlanErrors& errors, const PlanErrorOptions& options) {
  std::int64_t strict = 0;
  double iou_sum = 0.0;
  double matched_iou_sum = 0.0;
  for (const RoomMatch& pair : errors.room_pairs) {
    iou_sum += pair.iou;
    if (pair.iou >= options.strict_iou_threshold) ++strict;
    if (pair.iou < options.iou_threshold) continue;
    errors.room_matches.push_back(pair);
    matched_iou_sum += pair.iou;
  }
  const std::int64_t matched = std::ssize(errors.room_matches);
  const DetectionScore rooms = detection_score(matched, errors.rooms, errors.true_rooms);
  errors.precision = rooms.precision;
  errors.recall = rooms.recall;
  errors.f1 = rooms.f1;
  errors.strict = detection_score(strict, errors.rooms, errors.true_rooms);
  errors.mean_iou = ratio(matched_iou_sum, static_cast<double>(matched));
  errors.mean_true_iou = ratio(iou_sum, static_cast<double>(errors.true_rooms));
}

void compare_rooms(PlanErrors& errors, const FloorPlan& plan, const FloorPlan& truth,
                   const Pose2& truth_from_building, const PlanErrorOptions& options) {
  errors.rooms = std::ssize(plan.rooms);
  errors.true_rooms = std::ssize(truth.rooms);
  const Overlaps overlaps = overlaps_of(plan, truth, truth_from_building);
  const IndexPairs pairs = pair_rooms(overlaps, options.iou_threshold);
  for (const auto& [i, j] : pairs) {
    errors.room_pairs.push_back({plan.rooms[i].id, truth.rooms[j].id, overlaps.iou(i, j)});
  }
  std::stable_sort(errors.room_pairs.begin(), errors.room_pairs.end(),
                   [](const RoomMatch& a, const RoomMatch& b) { return a.iou > b.iou; });
  errors.segmentation = segmentation_of(plan, truth, overlaps, pairs, options.piece_share);
  score_rooms(errors, options);
}

Point2 middle(const Segment2& segment) { return (segment.a + segment.b) / 2.0; }

double width_m(const PlanDoor& door) { return (door.jambs.b - door.jambs.a).norm(); }

/// A pair inside the gate outweighs all distances; among as many pairs the nearest win.
std::vector<DoorMatch> match_doors(const FloorPlan& plan, const FloorPlan& truth,
                                   const Pose2& truth_from_building, double gate_m) {
  const double bonus = gate_m * static_cast<double>(plan.doors.size() + 1) + 1.0;
  const auto distance_m = [&](std::size_t i, std::size_t j) {
    const Point2 ours = truth_from_building * middle(plan.doors[i].jambs);
    return (ours - middle(truth.doors[j].jambs)).norm();
  };
  WeightTable weights(plan.doors.size(), std::vector<double>(truth.doors.size(), 0.0));
  for (std::size_t i = 0; i < plan.doors.size(); ++i) {
    for (std::size_t j = 0; j < truth.doors.size(); ++j) {
      if (distance_m(i, j) <= gate_m) weights[i][j] = bonus - distance_m(i, j);
    }
  }
  std::vector<DoorMatch> matches;
  const auto columns = best_assignment(weights);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (!columns[i]) continue;
    const PlanDoor& door = plan.doors[i];
    const PlanDoor& true_door = truth.doors[*columns[i]];
    matches.push_back(
        {door.id, true_door.id, distance_m(i, *columns[i]), width_m(door) - width_m(true_door)});
  }
  std::stable_sort(matches.begin(), matches.end(), [](const DoorMatch& a, const DoorMatch& b) {
    return a.distance_m < b.distance_m;
  });
  return matches;
}

/// Whether the path crosses the line between the jambs; touching it counts.
bool crosses(const Trajectory& path, const Segment2& jambs) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Segment2 step{path[i - 1].pose.position(), path[i].pose.position()};
    if (!step.a.allFinite() || !step.b.allFinite()) continue;
    if (crossing_fraction(step, jambs)) return true;
  }
  return false;
}

void find_used_doors(PlanErrors& errors, const FloorPlan& truth, const Trajectory& true_path) {
  for (const PlanDoor& door : truth.doors) {
    if (!crosses(true_path, door.jambs)) continue;
    errors.used_true_doors.push_back(door.id);
    const bool matched =
        std::any_of(errors.door_matches.begin(), errors.door_matches.end(),
                    [&](const DoorMatch& match) { return match.true_door == door.id; });
    if (!matched) errors.missed_used_doors.push_back(door.id);
  }
}

void compare_doors(PlanErrors& errors, const FloorPlan& plan, const FloorPlan& truth,
                   const Pose2& truth_from_building, const Trajectory& true_path,
                   const PlanErrorOptions& options) {
  errors.doors = std::ssize(plan.doors);
  errors.true_doors = std::ssize(truth.doors);
  errors.door_matches = match_doors(plan, truth, truth_from_building, options.door_gate_m);
  const std::int64_t matched = std::ssize(errors.door_matches);
  errors.door_score = detection_score(matched, errors.doors, errors.true_doors);
  double distances_m = 0.0;
  double width_errors_m = 0.0;
  for (const DoorMatch& match : errors.door_matches) {
    distances_m += match.distance_m;
    width_errors_m += std::abs(match.width_error_m);
  }
  if (matched > 0) {
    errors.mean_door_distance_m = distances_m / static_cast<double>(matched);
    errors.mean_door_width_error_m = width_errors_m / static_cast<double>(matched);
  }
  find_used_doors(errors, truth, true_path);
  std::map<RoomId, RoomId> true_room_of;
  for (const RoomMatch& match : errors.room_matches) true_room_of[match.room] = match.true_room;
  errors.graph = plan_graph_errors(plan, truth, true_room_of);
}

}  // namespace

PlanErrors plan_errors(const FloorPlan& plan, const FloorPlan& truth,
                       const Pose2& truth_from_building, const Trajectory& true_path,
                       const PlanErrorOptions& options) {
  PlanErrors errors;
  compare_rooms(errors, plan, truth, truth_from_building, options);
  errors.doors_known = options.doors_known;
  if (options.doors_known) {
    compare_doors(errors, plan, truth, truth_from_building, true_path, options);
  }
  return errors;
}

}  // namespace roomatlas
