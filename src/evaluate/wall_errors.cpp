// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/wall_errors.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "corners.hpp"
#include "detection_score.hpp"
#include "segment_index.hpp"

namespace roomatlas {
namespace {

constexpr double kDoorDepthM = 0.3;  ///< a boundary this near a door line is the door

/// A plan's rooms and doors in the truth's frame.
struct Walls {
  std::vector<Ring> rings;  ///< boundaries of the rooms asked for; outer ones counter-clockwise
  std::vector<Segment2> doors;
};

Walls walls_of(const FloorPlan& plan, const Pose2& truth_from_plan,
               const std::set<RoomId>* only = nullptr) {
  Walls walls;
  for (const PlanRoom& room : plan.rooms) {
    if (only != nullptr && !only->contains(room.id)) continue;
    for (const Polygon& part : room.parts) {
      const Polygon placed = transformed(truth_from_plan, part);
      walls.rings.push_back(placed.outer);
      for (const Ring& hole : placed.holes) walls.rings.push_back(hole);
    }
  }
  for (const PlanDoor& door : plan.doors) {
    walls.doors.push_back(transformed(truth_from_plan, door.jambs));
  }
  return walls;
}

/// Whether a point of a boundary lies in a doorway.
bool in_door(const Segment2& door, const Point2& point) {
  const Point2 along = door.b - door.a;
  const double length_m = along.norm();
  if (!(length_m > 0.0)) return false;
  const double at_m = along.dot(point - door.a) / length_m;
  return at_m > 0.0 && at_m < length_m &&
         std::abs(cross(along / length_m, point - door.a)) <= kDoorDepthM;
}

std::vector<Point2> samples_of(const Walls& walls, double step_m) {
  std::vector<Point2> samples;
  for (const Ring& ring : walls.rings) {
    double next_m = step_m / 2.0;  // of the next sample, from the corner on
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2 along = ring[(i + 1) % ring.size()] - ring[i];
      const double length_m = along.norm();
      for (; next_m < length_m; next_m += step_m) {
        const Point2 point = ring[i] + next_m / length_m * along;
        const bool is_door =
            std::any_of(walls.doors.begin(), walls.doors.end(),
                        [&](const Segment2& door) { return in_door(door, point); });
        if (!is_door) samples.push_back(point);
      }
      next_m -= length_m;
    }
  }
  return samples;
}

/// The value below which a share of the sorted values lies: the nearest rank.
double quantile(const std::vector<double>& sorted, double share) {
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::clamp<std::size_t>(rank, 1, sorted.size()) - 1];
}

WallDistances distances(const Walls& from, const Walls& to, double step_m) {
  const SegmentIndex index(to.rings);
  std::vector<double> values;
  if (!index.empty()) {
    for (const Point2& sample : samples_of(from, step_m)) values.push_back(index.distance(sample));
  }
  WallDistances result;
  result.samples = std::ssize(values);
  if (values.empty()) return result;
  std::sort(values.begin(), values.end());
  result.median_m = quantile(values, 0.5);
  result.percentile_95_m = quantile(values, 0.95);
  return result;
}

void compare_corners(WallErrors& errors, const std::vector<Corner>& ours,
                     const std::vector<Corner>& theirs, const std::vector<CornerMatch>& matches,
                     double angle_gate_deg) {
  errors.corners = std::ssize(ours);
  errors.true_corners = std::ssize(theirs);
  std::int64_t right = 0;
  for (const CornerMatch& match : matches) {
    if (same_directions(ours[match.ours], theirs[match.theirs], radians(angle_gate_deg))) ++right;
  }
  errors.corner_score = detection_score(std::ssize(matches), errors.corners, errors.true_corners);
  errors.angle_score = detection_score(right, errors.corners, errors.true_corners);
}

void compare_areas(WallErrors& errors, const FloorPlan& plan, const FloorPlan& truth,
                   const std::vector<RoomMatch>& matches) {
  const auto area_of = [](const FloorPlan& in, RoomId id) {
    double sum_m2 = 0.0;
    for (const PlanRoom& room : in.rooms) {
      if (room.id != id) continue;
      for (const Polygon& part : room.parts) sum_m2 += area(part);
    }
    return sum_m2;
  };
  double sum = 0.0;
  for (const RoomMatch& match : matches) {
    errors.areas.push_back(
        {match.room, match.true_room, area_of(plan, match.room), area_of(truth, match.true_room)});
    const RoomAreaError& pair = errors.areas.back();
    sum += ratio(std::abs(pair.area_m2 - pair.true_area_m2), pair.true_area_m2);
  }
  if (!matches.empty()) errors.mean_area_error = sum / static_cast<double>(matches.size());
}

struct Pair {
  Point2 ours;
  Point2 truth;
};

/// Slope of ours over truth by least squares; NaN where the truth hardly spreads.
Stretch stretch_of(const std::vector<Pair>& pairs) {
  constexpr double kLeastSpreadM = 0.5;  // of the places along an axis: with less a slope is noise
  Stretch stretch;
  stretch.pairs = std::ssize(pairs);
  if (pairs.size() < 3) return stretch;
  const auto count = static_cast<double>(pairs.size());
  Point2 mean_ours = Point2::Zero();
  Point2 mean_truth = Point2::Zero();
  for (const Pair& pair : pairs) {
    mean_ours += pair.ours / count;
    mean_truth += pair.truth / count;
  }
  Point2 mixed = Point2::Zero();
  Point2 squares = Point2::Zero();
  for (const Pair& pair : pairs) {
    const Point2 truth = pair.truth - mean_truth;
    mixed += truth.cwiseProduct(pair.ours - mean_ours);
    squares += truth.cwiseProduct(truth);
  }
  const double least = count * kLeastSpreadM * kLeastSpreadM;
  if (squares.x() > least) stretch.x = mixed.x() / squares.x();
  if (squares.y() > least) stretch.y = mixed.y() / squares.y();
  if (squares.sum() > least) stretch.both = mixed.sum() / squares.sum();
  return stretch;
}

std::vector<Pair> door_pairs(const FloorPlan& plan, const FloorPlan& truth,
                             const Pose2& truth_from_building, const PlanErrors& errors) {
  const auto middles = [](const FloorPlan& in) {
    std::map<std::int64_t, Point2> found;
    for (const PlanDoor& door : in.doors) found[door.id] = (door.jambs.a + door.jambs.b) / 2.0;
    return found;
  };
  const auto ours = middles(plan);
  const auto theirs = middles(truth);
  std::vector<Pair> pairs;
  for (const DoorMatch& match : errors.door_matches) {
    pairs.push_back({truth_from_building * ours.at(match.door), theirs.at(match.true_door)});
  }
  return pairs;
}

}  // namespace

WallErrors wall_errors(const FloorPlan& plan, const FloorPlan& truth,
                       const Pose2& truth_from_building, const PlanErrors& errors,
                       const WallErrorOptions& options) {
  std::set<RoomId> matched;
  for (const RoomMatch& match : errors.room_matches) matched.insert(match.true_room);
  const Walls ours = walls_of(plan, truth_from_building);
  const Walls theirs = walls_of(truth, Pose2{});
  WallErrors result;
  result.plan_to_truth = distances(ours, theirs, options.sample_m);
  result.truth_to_plan = distances(walls_of(truth, Pose2{}, &matched), ours, options.sample_m);

  const CornerOptions corner{options.simplify_m, radians(options.min_corner_deg)};
  const std::vector<Corner> our_corners = corners_of(ours.rings, corner);
  const std::vector<Corner> true_corners = corners_of(theirs.rings, corner);
  const auto matches = match_corners(our_corners, true_corners, options.corner_gate_m);
  compare_corners(result, our_corners, true_corners, matches, options.angle_gate_deg);
  compare_areas(result, plan, truth, errors.room_matches);

  std::vector<Pair> pairs;
  for (const CornerMatch& match : matches) {
    if (same_directions(our_corners[match.ours], true_corners[match.theirs],
                        radians(options.angle_gate_deg))) {
      pairs.push_back({our_corners[match.ours].point, true_corners[match.theirs].point});
    }
  }
  constexpr std::size_t kEnoughCorners = 4;  // with fewer, doors tell more
  const bool by_doors = pairs.size() < kEnoughCorners;
  result.stretch =
      stretch_of(by_doors ? door_pairs(plan, truth, truth_from_building, errors) : pairs);
  result.stretch.of_doors = by_doors;
  return result;
}

}  // namespace roomatlas
