// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/evaluate/plan_errors.hpp"

#include <cstdint>
#include <limits>
#include <vector>

namespace roomatlas {

/// Distances from samples of one plan's walls to the nearest wall of the other.
struct WallDistances {
  std::int64_t samples = 0;
  double median_m = std::numeric_limits<double>::quiet_NaN();
  double percentile_95_m = std::numeric_limits<double>::quiet_NaN();
};

struct RoomAreaError {
  RoomId room = 0;
  RoomId true_room = 0;
  double area_m2 = 0.0;
  double true_area_m2 = 0.0;
};

/// How much longer the plan is than the truth along the truth's axes: 1.02 is two per cent too
/// long. NaN where fewer than three pairs, or pairs that hardly spread, tell it.
struct Stretch {
  double x = std::numeric_limits<double>::quiet_NaN();
  double y = std::numeric_limits<double>::quiet_NaN();
  double both = std::numeric_limits<double>::quiet_NaN();  ///< one factor for both axes
  std::int64_t pairs = 0;
  bool of_doors = false;  ///< from matched doors, because too few corners matched
};

struct WallErrors {
  WallDistances plan_to_truth;  ///< from all walls of the plan: walls invented or moved
  WallDistances truth_to_plan;  ///< from the walls of the true rooms that have a match
  std::int64_t corners = 0;
  std::int64_t true_corners = 0;
  DetectionScore corner_score;  ///< corners matched by their place
  DetectionScore angle_score;  ///< of those, the ones whose two walls also have the true directions
  std::vector<RoomAreaError> areas;                                   ///< of matched rooms
  double mean_area_error = std::numeric_limits<double>::quiet_NaN();  ///< share of the true area
  Stretch stretch;
};

struct WallErrorOptions {
  double sample_m = 0.05;        ///< along walls
  double corner_gate_m = 0.3;    ///< corners farther apart are not the same
  double angle_gate_deg = 15.0;  ///< walls of one corner agree to this
  double min_corner_deg = 30.0;  ///< a boundary that turns less has no corner there
  double simplify_m = 0.15;      ///< corners are those of boundaries simplified to this, so that
                                 ///< pixels and ripples are none
};

/// Compares walls. A wall is the side that faces a room: the boundaries of the rooms without the
/// doors in them, so that a label picture has walls too. Corners are matched nearest first, within
/// the gate, one to one.
/// @param errors of the same two plans: which rooms and doors belong together
[[nodiscard]] WallErrors wall_errors(const FloorPlan& plan, const FloorPlan& truth,
                                     const Pose2& truth_from_building, const PlanErrors& errors,
                                     const WallErrorOptions& options);

}  // namespace roomatlas
