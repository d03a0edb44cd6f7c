// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "roomatlas/match/align.hpp"
#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

struct ScanOdometryOptions {
  double cell_m = 0.1;  ///< of the map of the last metres, with which each sweep is matched
  ScanOptions scan;
  AlignOptions align{.first_gate_m = 0.4};  ///< as RoomLocalizer's, but farther: a guess is worse
  CorrelateOptions correlate{
      .reach_m = 0.3, .step_m = 0.05, .reach_rad = radians(15.0), .step_rad = radians(1.5)};
  int max_points = 240;             ///< of a sweep that are aligned
  double position_sigma_m = 0.15;   ///< of a step that goes on as the one before; smaller holds
  double heading_sigma_rad = 0.15;  ///< along corridors, larger follows whoever walks jerkily
  bool turns_are_told = false;      ///< the readings' headings are a gyro's ...
  double told_sigma_rad = 0.03;     ///< ... and off by so much a step
  double ease_share = 0.8;          ///< of points matched: no need to search
  double min_matched_share = 0.4;   ///< below it a sweep is not believed
  int min_matched = 20;
  double insert_every_m = 0.10;   ///< a sweep enters the map after so much motion ...
  double insert_every_deg = 5.0;  ///< ... or turn
  int kept = 150;                 ///< sweeps in the map; fewer forget where a corridor began
  double longest_lost_s = 3.0;    ///< without a match: the way cannot be told any more
};

/// The mission of a laser without odometry, with poses that come from matching each sweep with
/// those of the last metres: odometry that drifts, but follows every motion that the walls show.
/// What a bare corridor does not show, motion along it, is taken as going on. Turns that a gyro
/// told are where matching begins, however fast they were. Sonars pass as they are. Cost and memory
/// do not depend on the mission's length.
///
/// `next` throws NotEnoughError where no sweep fits for `longest_lost_s`.
[[nodiscard]] std::unique_ptr<MissionSource> scan_odometry(std::unique_ptr<MissionSource> mission,
                                                           const ScanOdometryOptions& options = {});

}  // namespace roomatlas
