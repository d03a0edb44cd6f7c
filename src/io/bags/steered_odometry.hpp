// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/gyro_track.hpp"
#include "bags/topic_choice.hpp"
#include "bags/transform_track.hpp"

#include "roomatlas/core/pose2.hpp"

#include <cstdint>
#include <deque>
#include <optional>

namespace roomatlas::io {

/// Odometry that turns as a gyro says: odometry's steps, each with the gyro's turn in the place of
/// its own. The gyro's drift is learnt anew whenever odometry stands. Without odometry the pose
/// turns on the spot, and the drift stays what it was told to be.
class SteeredOdometry {
 public:
  static constexpr std::int64_t kWaits_ns = 1'000'000'000;  ///< for the gyro, of odometry's time

  explicit SteeredOdometry(const GyroChoice& gyro, bool has_odometry = true)
      : gyro_(gyro), has_odometry_(has_odometry), drift_(gyro.drift_rad_per_s) {}

  void add_turn(std::int64_t stamp_ns, const Eigen::Vector3d& turn_rad_per_s);
  void add_odometry(std::int64_t stamp_ns, const Pose2& odom_from_robot);
  /// As a track has it: between two samples, else the nearest with how far beyond it is.
  [[nodiscard]] std::optional<TransformAt> at(std::int64_t stamp_ns) const;
  /// Steps whose turn the gyro did not tell: it is odometry's.
  [[nodiscard]] std::int64_t steps_without_gyro() const { return without_gyro_; }

 private:
  struct Sample {
    std::int64_t stamp_ns = 0;
    Pose2 reported;
    Pose2 steered;
  };
  void settle();
  void settle(const Sample& next);
  void learn_drift(const Sample& next);
  [[nodiscard]] std::optional<double> turn(std::int64_t from_ns, std::int64_t to_ns) const;

  GyroChoice gyro_;
  bool has_odometry_;
  GyroTrack turns_;
  std::deque<Sample> waiting_;  ///< by stamp
  std::deque<Sample> settled_;  ///< by stamp, the last seconds
  double drift_ = 0.0;          ///< rad a second
  std::int64_t still_since_ns_ = 0;
  std::int64_t without_gyro_ = 0;
};

}  // namespace roomatlas::io
