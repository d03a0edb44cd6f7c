// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <tuple>

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/evaluate/evaluate.hpp"
#include "roomatlas/merge/merge.hpp"

namespace roomatlas {
namespace {

/// One object of the plan and one of the truth that may be the same; less cost goes first.
struct Candidate {
  double cost = 0.0;
  std::size_t ours = 0;
  std::size_t truth = 0;
};

/// Keeps the cheapest candidates such that no object is in two of them, cheapest first. Ties go
/// to the earlier objects, so that the answer does not depend on the order of the candidates.
std::vector<Candidate> one_to_one(std::vector<Candidate> candidates, std::size_t ours,
                                  std::size_t truth) {
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.cost, a.ours, a.truth) < std::tie(b.cost, b.ours, b.truth);
  });
  std::vector<bool> ours_taken(ours, false);
  std::vector<bool> truth_taken(truth, false);
  std::erase_if(candidates, [&](const Candidate& candidate) {
    if (ours_taken[candidate.ours] || truth_taken[candidate.truth]) return true;
    ours_taken[candidate.ours] = truth_taken[candidate.truth] = true;
    return false;
  });
  return candidates;
}

/// What IoU needs of a room, in the truth's frame.
struct RoomShape {
  std::vector<Polygon> parts;
  double area_m2 = 0.0;
  Box2 box;
};

std::vector<RoomShape> shapes_of(const FloorPlan& plan, const Pose2& truth_from_plan) {
  std::vector<RoomShape> shapes;
  for (const PlanRoom& room : plan.rooms) {
    std::vector<Polygon> parts;
    for (const Polygon& part : room.parts) parts.push_back(transformed(truth_from_plan, part));
    RoomShape shape{union_of(parts), 0.0, {}};
    for (const Polygon& part : shape.parts) {
      shape.area_m2 += area(part);
      for (const Point2& point : part.outer) shape.box.extend(point);
    }
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

bool apart(const Box2& a, const Box2& b) {
  return a.empty() || b.empty() || (a.min.array() > b.max.array()).any() ||
         (b.min.array() > a.max.array()).any();
}

/// Intersection over union, [0, 1]; 0 for rooms without area.
double intersection_over_union(const RoomShape& a, const RoomShape& b) {
  if (apart(a.box, b.box)) return 0.0;
  const double shared_m2 = overlap_area(a.parts, b.parts);
  const double either_m2 = a.area_m2 + b.area_m2 - shared_m2;
  return either_m2 > 0.0 ? std::clamp(shared_m2 / either_m2, 0.0, 1.0) : 0.0;
}

std::vector<RoomMatch> match_rooms(const FloorPlan& plan, const FloorPlan& truth,
                                   const Pose2& truth_from_building, double iou_threshold) {
  const std::vector<RoomShape> shapes = shapes_of(plan, truth_from_building);
  const std::vector<RoomShape> true_shapes = shapes_of(truth, Pose2{});
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t j = 0; j < true_shapes.size(); ++j) {
      const double iou = intersection_over_union(shapes[i], true_shapes[j]);
      if (iou > 0.0 && iou >= iou_threshold) candidates.push_back({-iou, i, j});
    }
  }
  std::vector<RoomMatch> matches;
  for (const Candidate& found : one_to_one(candidates, shapes.size(), true_shapes.size())) {
    matches.push_back({plan.rooms[found.ours].id, truth.rooms[found.truth].id, -found.cost});
  }
  return matches;
}

Point2 middle(const Segment2& segment) { return (segment.a + segment.b) / 2.0; }

std::vector<DoorMatch> match_doors(const FloorPlan& plan, const FloorPlan& truth,
                                   const Pose2& truth_from_building, double gate_m) {
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < plan.doors.size(); ++i) {
    const Point2 ours = truth_from_building * middle(plan.doors[i].jambs);
    for (std::size_t j = 0; j < truth.doors.size(); ++j) {
      const double distance_m = (ours - middle(truth.doors[j].jambs)).norm();
      if (distance_m <= gate_m) candidates.push_back({distance_m, i, j});
    }
  }
  std::vector<DoorMatch> matches;
  for (const Candidate& found : one_to_one(candidates, plan.doors.size(), truth.doors.size())) {
    matches.push_back({plan.doors[found.ours].id, truth.doors[found.truth].id, found.cost});
  }
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

double ratio(double part, double whole) { return whole > 0.0 ? part / whole : 0.0; }

void score_rooms(PlanErrors& errors) {
  const auto matched = static_cast<double>(errors.room_matches.size());
  const auto rooms = static_cast<double>(errors.rooms);
  const auto true_rooms = static_cast<double>(errors.true_rooms);
  errors.precision = ratio(matched, rooms);
  errors.recall = ratio(matched, true_rooms);
  errors.f1 = ratio(2.0 * matched, rooms + true_rooms);
  double iou_sum = 0.0;
  for (const RoomMatch& match : errors.room_matches) iou_sum += match.iou;
  errors.mean_iou = ratio(iou_sum, matched);
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

}  // namespace

PlanErrors plan_errors(const FloorPlan& plan, const FloorPlan& truth,
                       const Pose2& truth_from_building, const Trajectory& true_path,
                       const PlanErrorOptions& options) {
  PlanErrors errors;
  errors.rooms = std::ssize(plan.rooms);
  errors.true_rooms = std::ssize(truth.rooms);
  errors.room_matches = match_rooms(plan, truth, truth_from_building, options.iou_threshold);
  errors.door_matches = match_doors(plan, truth, truth_from_building, options.door_gate_m);
  score_rooms(errors);
  find_used_doors(errors, truth, true_path);
  return errors;
}

}  // namespace roomatlas
