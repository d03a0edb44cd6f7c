// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

/// A reading, and where the robot is by odometry whose direction has been checked.
struct DeadReckoned {
  RangeReading reading;       ///< as in the log
  Pose2 reckoned_from_robot;  ///< continuous; starts at the first odometry pose
};

struct DeadReckonerOptions {
  bool find_reverse = true;     ///< off: odometry is taken as it is
  double stop_step_m = 0.03;    ///< a shorter step ends an interval: only there can a robot turn
                                ///< from forwards to backwards
  double min_apart_m = 0.18;    ///< pairs of readings nearer than this cannot tell
  double max_apart_m = 0.55;    ///< farther ones see too different things
  double range_sigma_m = 0.08;  ///< agreement of two readings of one wall
  double flip_log_odds = 3.0;   ///< evidence needed to reverse an interval ...
  double flip_log_odds_per_pair = 7.0;  ///< ... and this much from each pair on average. True
                                        ///< reversals give 9 and more, a smooth corridor up to 3.4
                                        ///< under bad odometry, sonars up to 6.4; smaller flips
                                        ///< falsely
};

/// Odometry that never reports a backward step counts each one double. Between two stops the
/// robot goes one way, and the readings tell which: returns carried along the reported motion, or
/// against it, land on what the earlier reading saw or do not.
///
/// A streaming object: readings wait until their interval is decided, a few steps; memory does not
/// grow. Intervals that stay undecided go the reported way, and so do steps that odometry itself
/// reports as backward.
class DeadReckoner {
 public:
  explicit DeadReckoner(const DeadReckonerOptions& options) : options_(options) {}

  /// Takes the next reading; returns those whose place is decided, in order.
  [[nodiscard]] std::vector<DeadReckoned> add(const RangeReading& reading);
  /// Returns the readings that still wait. Call once, at the end.
  [[nodiscard]] std::vector<DeadReckoned> finish();

  [[nodiscard]] int intervals_reversed() const { return intervals_reversed_; }

 private:
  [[nodiscard]] std::vector<DeadReckoned> release(bool reversed);
  [[nodiscard]] bool is_clearly_reversed() const;

  DeadReckonerOptions options_;
  std::optional<RangeReading> last_released_;
  Pose2 reckoned_from_last_;
  std::vector<RangeReading> waiting_;
  std::optional<bool> decided_;  ///< reversed or not, for the rest of this interval
  double log_odds_ = 0.0;        ///< of reversed against reported
  int pairs_ = 0;                ///< that it was summed over
  int intervals_reversed_ = 0;
};

/// How much better `later`'s returns agree with `earlier` when the motion between them is reversed
/// (its translation negated), as log odds; 0 where they cannot tell.
[[nodiscard]] double reverse_log_odds(const RangeReading& earlier, const RangeReading& later,
                                      const DeadReckonerOptions& options);

}  // namespace roomatlas
