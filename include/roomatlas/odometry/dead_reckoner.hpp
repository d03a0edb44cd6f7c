// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "roomatlas/odometry/drive_directions.hpp"

namespace roomatlas {

/// A reading, and where the robot is by odometry whose direction has been checked.
struct DeadReckoned {
  RangeReading reading;       ///< as in the log
  Pose2 reckoned_from_robot;  ///< continuous; starts at the first odometry pose
};

/// Decides the direction of each drive (`DriveDirection`) on a stream of readings: what a drive's
/// own first readings say must do. A sweep's returns near each other see the same wall, so that a
/// pair of readings counts as much as eight of them, and evidence is asked of each pair on average:
/// a smooth corridor gives a little either way, which adds up.
///
/// A streaming object: readings wait until their drive is decided, a few steps; memory does not
/// grow. Drives that stay undecided go the reported way, and so do steps that odometry itself
/// reports as backward. At more than about ten readings a second every step is a stop, and nothing
/// is turned round.
class DeadReckoner {
 public:
  explicit DeadReckoner(const DriveDirectionOptions& options) : options_(options) {}

  /// Takes the next reading; returns those whose place is decided, in order.
  [[nodiscard]] std::vector<DeadReckoned> add(const RangeReading& reading);
  /// Returns the readings that still wait. Call once, at the end.
  [[nodiscard]] std::vector<DeadReckoned> finish();

  /// So far. Of a mission that is corrected as a whole, `DriveDirections::drives_reversed` holds
  /// instead.
  [[nodiscard]] int drives_reversed() const { return drives_reversed_; }

 private:
  [[nodiscard]] std::vector<DeadReckoned> release(DriveDirection direction);
  [[nodiscard]] DriveDirection decide() const;
  /// Adds what a waiting reading and a new one say.
  void compare(const RangeReading& earlier, const RangeReading& later);

  DriveDirectionOptions options_;
  std::optional<RangeReading> last_released_;
  Pose2 reckoned_from_last_;
  std::vector<RangeReading> waiting_;
  std::optional<DriveDirection> decided_;  ///< for the rest of this drive
  double log_odds_ = 0.0;                  ///< of reversed against reported
  int pairs_ = 0;                          ///< that it was summed over
  int drives_reversed_ = 0;
};

/// How much better `later`'s returns agree with `earlier` when the motion between them is reversed
/// (its translation negated), as log odds; 0 where they cannot tell.
[[nodiscard]] double reverse_log_odds(const RangeReading& earlier, const RangeReading& later,
                                      const DriveDirectionOptions& options);

}  // namespace roomatlas
