// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/room_pose_errors.hpp"

#include <cmath>
#include <map>
#include <optional>

#include "roomatlas/evaluate/pose_lookup.hpp"

namespace roomatlas {
namespace {

/// Means over the poses of one visit.
struct VisitMeans {
  RoomId room = 0;
  std::int64_t poses = 0;
  Point2 placed = Point2::Zero();
  Point2 truth = Point2::Zero();
  double heading_error_rad = 0.0;  ///< true less placed
};

std::optional<VisitMeans> means_of(const PlacedVisit& visit, PoseLookup& true_pose) {
  VisitMeans means{visit.room, 0, Point2::Zero(), Point2::Zero(), 0.0};
  Point2 heading = Point2::Zero();
  for (const auto& [timestamp_s, placed] : visit.path) {
    const std::optional<FoundPose> found = true_pose.next(timestamp_s);
    if (!found) continue;
    const Pose2& truth = found->pose;
    ++means.poses;
    means.placed += placed.position();
    means.truth += truth.position();
    heading += direction(truth.theta_rad - placed.theta_rad);
  }
  if (means.poses == 0) return std::nullopt;
  means.placed /= static_cast<double>(means.poses);
  means.truth /= static_cast<double>(means.poses);
  means.heading_error_rad = std::atan2(heading.y(), heading.x());
  return means;
}

/// The motion that brings a visit to its true place.
Pose2 truth_from_placed(const VisitMeans& means) {
  const Pose2 turn{0.0, 0.0, wrap_angle(means.heading_error_rad)};
  const Point2 shift = means.truth - turn * means.placed;
  return {shift.x(), shift.y(), turn.theta_rad};
}

struct VisitError {
  double rotation_rad = 0.0;
  double translation_m = 0.0;
};

VisitError error_of(const VisitMeans& means, const Pose2& truth_from_building) {
  return {std::abs(wrap_angle(means.heading_error_rad - truth_from_building.theta_rad)),
          (means.truth - truth_from_building * means.placed).norm()};
}

Statistics over_rooms(const std::vector<RoomPoseError>& rooms, double RoomPoseError::*figure,
                      double scale) {
  std::vector<double> values;
  for (const RoomPoseError& room : rooms) values.push_back(scale * room.*figure);
  return statistics(std::move(values));
}

}  // namespace

RoomPoseErrors room_pose_errors(const std::vector<PlacedVisit>& visits, const Trajectory& truth,
                                const Pose2& truth_from_building) {
  PoseLookup true_pose(truth, {.match = TimeMatch::interpolate});
  std::optional<Pose2> truth_from_first;
  std::map<RoomId, RoomPoseError> rooms;
  for (const PlacedVisit& visit : visits) {
    const std::optional<VisitMeans> means = means_of(visit, true_pose);
    if (!means) continue;
    if (!truth_from_first) truth_from_first = truth_from_placed(*means);
    const VisitError error = error_of(*means, truth_from_building);
    const VisitError relative = error_of(*means, *truth_from_first);
    const auto poses = static_cast<double>(means->poses);
    RoomPoseError& room = rooms[visit.room];
    room.room = visit.room;
    room.visits += 1;
    room.poses += means->poses;
    room.rotation_rad += poses * error.rotation_rad;
    room.translation_m += poses * error.translation_m;
    room.relative_rotation_rad += poses * relative.rotation_rad;
    room.relative_translation_m += poses * relative.translation_m;
  }
  RoomPoseErrors result;
  for (auto& [id, room] : rooms) {
    for (double RoomPoseError::*sum :
         {&RoomPoseError::rotation_rad, &RoomPoseError::translation_m,
          &RoomPoseError::relative_rotation_rad, &RoomPoseError::relative_translation_m}) {
      room.*sum /= static_cast<double>(room.poses);
    }
    result.rooms.push_back(room);
  }
  result.rotation_deg = over_rooms(result.rooms, &RoomPoseError::rotation_rad, degrees(1.0));
  result.translation_m = over_rooms(result.rooms, &RoomPoseError::translation_m, 1.0);
  result.relative_rotation_deg =
      over_rooms(result.rooms, &RoomPoseError::relative_rotation_rad, degrees(1.0));
  result.relative_translation_m =
      over_rooms(result.rooms, &RoomPoseError::relative_translation_m, 1.0);
  return result;
}

}  // namespace roomatlas
