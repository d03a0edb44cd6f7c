// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "range_profile.hpp"
#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

/// What one sweep saw: its points, and how far it saw in each direction from where it looked.
struct SeenSweep {
  std::vector<Point2> points;  ///< robot's frame, metres; thinned
  RangeProfile profile;
};

[[nodiscard]] SeenSweep seen_sweep(const RangeReading& reading);

/// Counts of points of two sweeps, each in what the other saw.
struct Agreement {
  int points = 0;
  int agreeing = 0;
  int contradicting = 0;  ///< in the middle of what the other sweep saw through
  [[nodiscard]] int comparable() const { return agreeing + contradicting; }
  /// Of what can be compared, [0, 1]; 0 where nothing can.
  [[nodiscard]] double share() const;
};

[[nodiscard]] Agreement agreement_of(const SeenSweep& a, const SeenSweep& b, const Pose2& a_from_b);

struct SweepWindow {
  double reach_m = 0.5;
  double reach_rad = 0.5;
};

/// A sweep of several that hang together.
struct PlacedSweep {
  const SeenSweep* seen = nullptr;
  Pose2 side_from_sweep;  ///< in the frame of its side
};

/// The largest share that agrees, each sweep of `a` with each of `b`, anywhere in the window around
/// `a_from_b`; none where nowhere in it enough can be compared.
/// @param comparable_share of the points that must be comparable, [0, 1]
[[nodiscard]] std::optional<double> best_agreement_near(const std::vector<PlacedSweep>& a,
                                                        const std::vector<PlacedSweep>& b,
                                                        const Pose2& a_from_b,
                                                        const SweepWindow& window,
                                                        double comparable_share);

}  // namespace roomatlas
