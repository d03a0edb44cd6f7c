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
/// turn_share. Slips and dropouts of an encoder come on top, as the faults say.
/// The frame is a real robot's: it starts at (0, 0, 0).
class Odometer {
 public:
  explicit Odometer(const SimulationOptions& options);
  /// One without faults.
  Odometer(const OdometryErrors& errors, std::uint64_t seed);

  /// What was reported for one motion.
  struct Increment {
    double length_m = 0.0;
    double turn_rad = 0.0;
  };

  /// One more period of the clock begins.
  void tick();
  /// Adds a pure translation or a pure turn.
  Increment add(double length_m, double turn_rad);
  [[nodiscard]] const Pose2& odom_from_robot() const { return odom_from_robot_; }

 private:
  /// What an encoder that counts nothing leaves of a motion.
  [[nodiscard]] Increment counted(double length_m, double turn_rad) const;
  void slip(double driven_m, Increment& reported);

  enum class Encoder { both, left_fails, right_fails };

  OdometryErrors errors_;
  OdometryFaults faults_;
  double track_m_;  ///< between the wheels
  double period_s_;
  RandomStream heading_noise_;
  RandomStream slips_;
  RandomStream dropouts_;
  double slip_left_m_ = 0.0;          ///< of the present slip
  double slip_turn_rad_per_m_ = 0.0;  ///< of the present slip
  double dropout_left_s_ = 0.0;
  Encoder encoder_ = Encoder::both;
  Pose2 odom_from_robot_;
};

}  // namespace roomatlas
