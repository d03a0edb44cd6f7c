// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

struct DriveDirectionOptions {
  bool find_reverse = true;   ///< off: odometry is taken as it is
  double stop_step_m = 0.03;  ///< a shorter step ends an interval: only there can a robot turn
                              ///< from forwards to backwards
  double min_apart_m = 0.18;  ///< pairs of readings nearer than this cannot tell
  double max_apart_m = 0.55;  ///< farther ones hear different things
  double max_turn_rad = 0.9;  ///< between the two
  double range_sigma_m = 0.08;
  double other_share = 0.3;    ///< likelihood of a return on something else, the peak being 1
  double independence = 0.3;   ///< share of the evidence that is new: pairs overlap
  double flip_log_odds = 3.0;  ///< evidence needed to reverse an interval; smaller flips falsely
  double undecided_log_odds = -1.5;  ///< above it an interval counts as undecided
};

/// Which way the robot went in each step, where its odometry does not say.
struct DriveDirections {
  std::vector<bool> reversed;       ///< of the step that leads to each reading
  std::vector<double> undecided_m;  ///< path up to each reading in intervals that stay undecided
  int intervals_reversed = 0;
  bool odometry_is_signed = false;  ///< it reports backward steps itself: nothing was looked for
};

/// Some robots' odometry never reports a backward step, so that each counts double. Between two
/// stops a robot goes one way: returns of one reading are carried into a later one's cones by the
/// reported motion, and by the motion with its translation negated, and the ranges heard there
/// decide. The whole mission at once; `DeadReckoner` does the same on a stream.
[[nodiscard]] DriveDirections find_drive_directions(std::span<const RangeReading> readings,
                                                    const DriveDirectionOptions& options);

}  // namespace roomatlas
