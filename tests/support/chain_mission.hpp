// SPDX-License-Identifier: GPL-3.0-or-later
// Missions for tests of the offline stage: ASRs built from a literal list of visits, without any
// reading. True poses are known, and odometry's error is a literal too.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "roomatlas/asr/asr.hpp"
#include "roomatlas/graph/room_graph.hpp"

namespace roomatlas::test {

/// One visit to one space.
struct Visit {
  Ring room;              ///< its walls and its outline, in the building
  Pose2 entered_at;       ///< mid-point of the passage; theta is the direction of travel. It is the
                          ///< true pose of the ASR's frame; the first visit's is the robot's start
  double drift_deg = 0;   ///< how far odometry's heading is off when the visit ends
  double width_m = 0.9;   ///< of the doorway it was entered by; 0: an open passage
  bool is_linked = true;  ///< false: nothing tells how it was reached from the visit before
};

inline Ring rectangle(double min_x, double min_y, double max_x, double max_y) {
  return {{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}};
}

inline Pose2 pose_deg(double x_m, double y_m, double theta_deg) {
  return {x_m, y_m, wrap_angle(radians(theta_deg))};
}

inline PassageKind kind_of(const Visit& entered) {
  return entered.width_m > 0.0 ? PassageKind::doorway : PassageKind::open_passage;
}

/// The passage that leads into `entered`, with theta out of the ASR that sees it.
inline Exit exit_of(const Visit& entered, const Pose2& frame_from_pivot) {
  Exit exit;
  exit.kind = kind_of(entered);
  exit.frame_from_pivot = frame_from_pivot;
  exit.width_m = entered.width_m;
  const Point2 half(0.0, entered.width_m / 2.0);
  exit.jambs = {frame_from_pivot * half, frame_from_pivot * Point2(-half)};
  return exit;
}

/// A straight way from the frame's origin to `goal`, a sample at least every half metre.
inline std::vector<PathSample> straight_path(const Pose2& odom_from_asr, const Pose2& goal) {
  const double length_m = goal.position().norm();
  const int steps = std::max(2, static_cast<int>(std::ceil(length_m / 0.5)));
  std::vector<PathSample> path;
  for (int i = 0; i <= steps; ++i) {
    const Point2 at = goal.position() * i / steps;
    const double ahead = length_m > 0.0 ? std::atan2(goal.y_m, goal.x_m) : 0.0;
    const double theta = i == 0 ? 0.0 : i == steps ? goal.theta_rad : ahead;
    const Pose2 asr_from_robot{at.x(), at.y(), theta};
    path.push_back({static_cast<double>(i), asr_from_robot, odom_from_asr * asr_from_robot});
  }
  return path;
}

/// One ASR a visit, with ids 1, 2, 3 ... Each side of a room is a wall of its own. Shapes and
/// steps inside an ASR are exact: odometry's heading jumps by `drift_deg` at the exit pivot.
/// @param odom_from_building turns and moves odometry as a whole
inline std::vector<Asr> chain_mission(const std::vector<Visit>& visits,
                                      const Pose2& odom_from_building = {}) {
  std::vector<Asr> asrs;
  Pose2 odom_from_asr;
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const Visit& visit = visits[i];
    if (i == 0) odom_from_asr = odom_from_building * visit.entered_at;
    const Pose2 asr_from_building = inverse(visit.entered_at);

    Asr asr;
    asr.id = static_cast<AsrId>(i + 1);
    asr.odom_from_asr = odom_from_asr;
    asr.outline_asr = transformed(asr_from_building, Polygon{visit.room, {}});
    const Ring& corners = asr.outline_asr.outer;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      asr.walls.push_back({{corners[k], corners[(k + 1) % corners.size()]}, {true}});
    }
    asr.reference_point_asr = interior_point(asr.outline_asr);
    Pose2 goal{asr.reference_point_asr.x(), asr.reference_point_asr.y(), 0.0};

    if (i > 0) {
      asr.exits.push_back(exit_of(visit, {0.0, 0.0, wrap_angle(kPi)}));
      asr.exits.back().is_entry = true;
      if (visit.is_linked) asr.exits.back().neighbor = asr.id - 1;
    }
    if (i + 1 < visits.size()) {
      const Visit& next = visits[i + 1];
      goal = asr_from_building * next.entered_at * Pose2{0.0, 0.0, radians(visit.drift_deg)};
      asr.exits.push_back(exit_of(next, goal));
      if (next.is_linked) asr.exits.back().neighbor = asr.id + 1;
    }
    asr.path = straight_path(odom_from_asr, goal);
    odom_from_asr = odom_from_asr * goal;
    asrs.push_back(std::move(asr));
  }
  return asrs;
}

inline Placement true_placement(const std::vector<Visit>& visits) {
  Placement placement;
  for (std::size_t i = 0; i < visits.size(); ++i) {
    placement[static_cast<AsrId>(i + 1)] = visits[i].entered_at;
  }
  return placement;
}

/// Four corridors, 2 m wide, around a block of 20 m x 12 m, with doors where they meet. The robot
/// goes round counter-clockwise and then some: south, east, north, west, south again, east again.
///
///     +-----------------+
///     |__    north      |
///     |  |___________|__|
///     |w |           | e|
///     |__|___________|  |
///     |    south     |__|
///     +--------------+
inline std::vector<Visit> round_the_block(double drift_deg) {
  const Ring south = rectangle(0, 0, 18, 2);
  const Ring east = rectangle(18, 0, 20, 10);
  const Ring north = rectangle(2, 10, 20, 12);
  const Ring west = rectangle(0, 2, 2, 12);
  return {{south, pose_deg(9, 1, 0), drift_deg},    {east, pose_deg(18, 1, 0), drift_deg},
          {north, pose_deg(19, 10, 90), drift_deg}, {west, pose_deg(2, 11, 180), drift_deg},
          {south, pose_deg(1, 2, -90), drift_deg},  {east, pose_deg(18, 1, 0), drift_deg}};
}

/// "The doorway behind which `first` began is the one behind which `again` began."
inline PassageEdge same_doorway(AsrId first, AsrId again, double turn_rad = 0.0) {
  return {first,
          again,
          {0.0, 0.0, turn_rad},
          PassageKind::doorway,
          EdgeSource::recognised,
          /*path_length_m=*/0.0,
          /*turning=*/{}};
}

}  // namespace roomatlas::test
