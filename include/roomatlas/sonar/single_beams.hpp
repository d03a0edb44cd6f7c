// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/mission/mission.hpp"
#include "roomatlas/odometry/drive_directions.hpp"
#include "roomatlas/sonar/sonar_trajectory.hpp"

namespace roomatlas {

/// Some of the beams of a mission's lasers, each a sonar of its own with a cone that is next to
/// none: walls that it passes along in consecutive readings are what a sonar hears of them, only
/// sharper. At most 96, evenly over the sweep, and of a long mission fewer: what they cost grows
/// with their square and with the mission.
class SingleBeams {
 public:
  /// Of more some eight beams would not be left.
  static constexpr std::size_t kMostReadings = 50'000;

  /// @param readings of the whole mission, 1 to `kMostReadings`
  /// @throws std::invalid_argument for another number
  explicit SingleBeams(std::size_t readings);

  /// The reading with those beams alone.
  [[nodiscard]] RangeReading of(RangeReading reading);

 private:
  struct Ring {
    std::shared_ptr<const RangeSensor> laser;  ///< whose address is the key
    std::shared_ptr<const RangeSensor> sonars;
    std::size_t every = 1;  ///< beam that is taken
  };
  [[nodiscard]] Ring ring_of(const std::shared_ptr<const RangeSensor>& laser) const;

  std::size_t most_ = 0;  ///< beams of a sweep
  std::map<const RangeSensor*, Ring> rings_;
};

/// Corrects a mission with a laser as `correct_sonar_trajectory` does one with sonars, beginning
/// with the headings of matched sweeps and odometry's lengths: sweeps know their turns better than
/// how far they went.
/// @param readings of `SingleBeams`, with odometry as reported
/// @param matched poses of the same readings as they were found sweep by sweep
/// @param options of the batch; how far walls are heard is that of beams
/// @param before_attempt,jobs see `correct_sonar_trajectory`
/// @returns nothing where walls speak for `matched` nearly as much, and where there are no readings
/// @throws std::invalid_argument where there is not one pose a reading
[[nodiscard]] std::optional<SonarTrajectory> correct_single_beams(
    std::vector<RangeReading> readings, std::span<const Pose2> matched,
    const DriveDirectionOptions& directions, SonarTrajectoryOptions options,
    const std::function<void()>& before_attempt = {}, int jobs = 1);

}  // namespace roomatlas
