// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "obstacles.hpp"
#include "odometer.hpp"
#include "people.hpp"
#include "range_reader.hpp"
#include "roomatlas/simulate/simulate.hpp"
#include "route.hpp"
#include "sliding_doors.hpp"

#include <deque>
#include <memory>
#include <vector>

namespace roomatlas {

/// Throws UsageError naming the first option out of its range.
void require_sound(const SimulationOptions& options);

/// The robot in its world: it moves, its wheels report, its sensor reads. One call is one period
/// of the clock.
class Robot {
 public:
  Robot(const FloorPlan& world, const SimulationOptions& options, const Pose2& world_from_start);

  /// Senses where the robot stands, at time 0. Call once, first.
  [[nodiscard]] SimulatedStep start();

  /// Makes the motions of one period, whatever is in the way, and senses where they end. People
  /// walk on meanwhile.
  [[nodiscard]] SimulatedStep step(const std::vector<Motion>& motions);

  /// Whether the robot's rectangle would stand in an obstacle after these motions. People are
  /// none: they make way.
  [[nodiscard]] bool would_touch(const std::vector<Motion>& motions) const;

  /// Whether the robot was shoved aside since the last call: where it is now, its straight way
  /// back is clear. Its wheels did not notice. Never without `faults.pushes_per_hour`.
  [[nodiscard]] bool is_pushed();

  [[nodiscard]] const Pose2& world_from_robot() const { return world_from_robot_; }

 private:
  [[nodiscard]] SimulatedStep sense(OdometryStep odometry);
  [[nodiscard]] Pose2 late_odometry();
  [[nodiscard]] bool is_clear(const Segment2& way) const;

  SimulationOptions options_;
  ObstacleIndex obstacles_;
  People people_;
  SlidingDoors doors_;
  std::shared_ptr<const RangeSensor> sensor_;
  Odometer odometer_;
  RangeReader reader_;
  RandomStream pushes_;
  std::deque<Pose2> odom_from_robot_;  ///< of the last periods, the latest first
  Pose2 world_from_robot_;
  double periods_ = 0.0;
};

}  // namespace roomatlas
