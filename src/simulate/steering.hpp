// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "explorer_map.hpp"
#include "route.hpp"

#include <deque>
#include <optional>
#include <vector>

namespace roomatlas {

/// What the robot does in one period: it turns, then drives; or the other way round.
struct Steering {
  double turn_rad = 0.0;
  double length_m = 0.0;
  bool drives_first = false;
};

struct SteeringLimits {
  double max_length_m = 0.04;  ///< in one period
  double max_turn_rad = 0.08;  ///< in one period
};

/// One step along a way, by the polar histogram (paper II.A, equations (1) to (3)): of the
/// directions near the way's, the one with little in it. A step that would touch what is in the
/// map or in the last sweep is not made: the robot turns, or backs off.
/// @param way in the map's frame, from the robot's place to the goal; empty: nothing is done
/// @param echoes_map where close obstacles were met lately, in the map's frame
[[nodiscard]] Steering steer(const ExplorerMap& map, const std::vector<Point2>& echoes_map,
                             const Pose2& map_from_robot, const RobotFootprint& footprint,
                             const Polyline& way, const SteeringLimits& limits);

/// A step straight back or ahead, where it is clear: for a robot that does not get away.
[[nodiscard]] Steering shuffle(const ExplorerMap& map, const std::vector<Point2>& echoes_map,
                               const Pose2& map_from_robot, const RobotFootprint& footprint,
                               bool back_first, const SteeringLimits& limits);

/// The steps that led to where the robot is. Taking them back, one by one, touches nothing: the
/// robot has been there. It needs no map and no pose for that.
class Trace {
 public:
  void add(const Steering& made);
  /// The step that takes the last one back, which is then forgotten; nothing where none is left.
  [[nodiscard]] std::optional<Steering> take_back();

 private:
  std::deque<Steering> steps_;
};

/// Echoes from close by, of the last second or so. They are too exact to be forgotten at once, and
/// no later beam wears them away as in the map.
class CloseEchoes {
 public:
  void add(const RangeReading& reading, const Pose2& map_from_robot);
  [[nodiscard]] std::vector<Point2> points_map() const;

 private:
  std::deque<std::vector<Point2>> sweeps_;
};

}  // namespace roomatlas
