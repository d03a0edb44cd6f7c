// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/pose2.hpp"

#include <deque>
#include <optional>

namespace roomatlas::io {

/// The last few odometry poses in file order. Clocks of real logs step back, so times are compared
/// only between neighbours in the file, and only near the place that is asked for.
class OdometryTrack {
 public:
  static constexpr std::size_t kLookBack = 16;  ///< odometry lines kept

  /// A pose that steps back in time starts afresh: what came before is of another epoch.
  void add(const StampedPose& line);
  /// The pose at that time, where two kept neighbours (or the newest line alone) enclose it; the
  /// newest such pair holds.
  [[nodiscard]] std::optional<Pose2> at(double timestamp_s) const;
  [[nodiscard]] std::optional<StampedPose> newest() const;

 private:
  std::deque<StampedPose> lines_;
};

/// A reading without a pose that waits for odometry after it. It waits for at most `kLookAhead`
/// odometry lines, then takes the neighbour in the file that is nearer in time.
class AwaitedPose {
 public:
  static constexpr int kLookAhead = 16;  ///< odometry lines

  /// @param before the odometry line before the reading, where there is one
  AwaitedPose(double timestamp_s, const std::optional<StampedPose>& before)
      : timestamp_s_(timestamp_s), before_(before), previous_(before) {}

  /// Shows it the next odometry line of the file; the pose, once it is known.
  [[nodiscard]] std::optional<Pose2> see(const StampedPose& line);
  /// The best guess from what it has seen; nothing when there was no odometry at all.
  [[nodiscard]] std::optional<Pose2> give_up() const;

 private:
  double timestamp_s_ = 0.0;
  std::optional<StampedPose> before_;
  std::optional<StampedPose> first_after_;
  std::optional<StampedPose> previous_;
  int seen_ = 0;
};

}  // namespace roomatlas::io
