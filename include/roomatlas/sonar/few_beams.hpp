// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/mission/mission.hpp"
#include "roomatlas/odometry/drive_directions.hpp"
#include "roomatlas/sonar/sonar_trajectory.hpp"

namespace roomatlas {

/// Most beams of a laser whose single sweeps tell so little that a mission is better corrected as a
/// whole, if its walls say so. Sweeps of more hold by themselves, and cost the more here.
inline constexpr std::size_t kFewBeams = 64;

/// Whether all readings are of lasers of few beams.
[[nodiscard]] bool all_of_few_beams(std::span<const RangeReading> readings);

/// Corrects a mission with a laser of few beams as `correct_sonar_trajectory` does one with sonars:
/// walls that single beams pass along in consecutive readings are what a sonar hears of them, only
/// sharper. It begins with the headings of matched sweeps and odometry's lengths: a narrow view
/// knows its turns better than how far it went.
/// @param readings of lasers alone, with odometry as reported
/// @param matched poses of the same readings as they were found sweep by sweep
/// @param options of the batch; how far walls are heard is that of beams
/// @param before_attempt,jobs see `correct_sonar_trajectory`
/// @returns nothing where walls speak for `matched` as much, and of missions that are too long
/// @throws std::invalid_argument where there is not one pose a reading
[[nodiscard]] std::optional<SonarTrajectory> correct_few_beams(
    std::vector<RangeReading> readings, std::span<const Pose2> matched,
    const DriveDirectionOptions& directions, SonarTrajectoryOptions options,
    const std::function<void()>& before_attempt = {}, int jobs = 1);

}  // namespace roomatlas
