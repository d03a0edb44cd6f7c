// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "random_stream.hpp"
#include "roomatlas/core/pose2.hpp"
#include "roomatlas/simulate/simulate.hpp"

#include <cstdint>

namespace roomatlas {

/// What wheel odometry makes of true motions. Over a driven length L (of any number of pieces)
/// the reported length is L (1 + length_share) and the heading error is normal with mean
/// heading_bias L and standard deviation heading_noise sqrt(L). A turn is reported larger by
/// turn_share.
/// The frame is a real robot's: it starts at (0, 0, 0).
class Odometer {
 public:
  Odometer(const OdometryErrors& errors, std::uint64_t seed);

  /// What was reported for one motion.
  struct Increment {
    double length_m = 0.0;
    double turn_rad = 0.0;
  };

  /// Adds a pure translation or a pure turn.
  Increment add(double length_m, double turn_rad);
  [[nodiscard]] const Pose2& odom_from_robot() const { return odom_from_robot_; }

 private:
  OdometryErrors errors_;
  RandomStream heading_noise_;
  Pose2 odom_from_robot_;
};

}  // namespace roomatlas
