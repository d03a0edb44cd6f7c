// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/sonar/single_beams.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "driven_path.hpp"
#include "roomatlas/odometry/lag_learner.hpp"
#include "roomatlas/odometry/late_odometry.hpp"
#include "roomatlas/sonar/contradiction.hpp"
#include "sonar_attempt.hpp"

namespace roomatlas {
namespace {

constexpr double kHalfConeRad = radians(0.5);  // of a beam: as good as none
constexpr std::size_t kMostRanges = 400'000;   // of a mission: its time grows with them ...
constexpr std::size_t kMostBeams = 96;  // ... and with the pairs of what they see: their square
/// Farther walls bend by what the heading drifts from reading to reading. A sonar hears to 4 m.
constexpr double kFarthestM = 8.0;
/// Of the sweeps' score, by which the batch's must be better. Where both are alike the sweeps lie
/// more exactly: they are of all beams.
constexpr double kBetterThanSweeps = 0.005;

double lag_of(std::span<const RangeReading> readings, std::span<const Pose2> matched) {
  LagLearner lag;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const double turn_rad = i == 0 ? 0.0 : matched[i].theta_rad - matched[i - 1].theta_rad;
    lag.add(readings[i].timestamp_s, readings[i].odom_from_robot.theta_rad, wrap_angle(turn_rad));
  }
  return lag.lag_s();
}

/// Odometry that is late put right.
void make_timely(std::vector<RangeReading>& readings, double lag_s) {
  if (lag_s == 0.0) return;
  LateOdometry late;
  for (const RangeReading& reading : readings) late.add({reading, reading.odom_from_robot});
  late.finish();
  for (RangeReading& reading : readings) {
    if (const auto next = late.next(lag_s)) reading.odom_from_robot = next->reckoned_from_robot;
  }
}

/// Odometry's lengths with the turns of matched sweeps.
std::vector<RangeReading> with_turns_of(std::span<const Pose2> matched,
                                        std::vector<RangeReading> readings) {
  Pose2 reported_before = readings.front().odom_from_robot;
  readings.front().odom_from_robot = matched.front();
  for (std::size_t i = 1; i < readings.size(); ++i) {
    const Pose2 reported = readings[i].odom_from_robot;
    const Pose2 step = inverse(reported_before) * reported;
    const double turn_rad = wrap_angle(matched[i].theta_rad - matched[i - 1].theta_rad);
    Pose2 driven = Pose2{0.0, 0.0, (turn_rad - step.theta_rad) / 2.0} * step;
    driven.theta_rad = turn_rad;
    readings[i].odom_from_robot = readings[i - 1].odom_from_robot * driven;
    reported_before = reported;
  }
  return readings;
}

}  // namespace

SingleBeams::SingleBeams(std::size_t readings) {
  if (readings == 0 || readings > kMostReadings) {
    throw std::invalid_argument("SingleBeams: of so many readings there are none");
  }
  most_ = std::min(kMostBeams, kMostRanges / readings);
}

SingleBeams::Ring SingleBeams::ring_of(const std::shared_ptr<const RangeSensor>& laser) const {
  const std::vector<Pose2>& beams = laser->robot_from_beam;
  Ring ring{laser, nullptr, std::max<std::size_t>(1, (beams.size() + most_ - 1) / most_)};
  RangeSensor sonars{SensorKind::sonar, {}, kHalfConeRad, laser->max_range_m};
  for (std::size_t i = ring.every / 2; i < beams.size(); i += ring.every) {
    sonars.robot_from_beam.push_back(beams[i]);
  }
  ring.sonars = std::make_shared<const RangeSensor>(std::move(sonars));
  return ring;
}

RangeReading SingleBeams::of(RangeReading reading) {
  auto known = rings_.find(reading.sensor.get());
  if (known == rings_.end()) {
    known = rings_.emplace(reading.sensor.get(), ring_of(reading.sensor)).first;
  }
  const Ring& ring = known->second;
  std::vector<float> ranges_m;
  ranges_m.reserve(ring.sonars->robot_from_beam.size());
  for (std::size_t i = ring.every / 2; i < reading.ranges_m.size(); i += ring.every) {
    ranges_m.push_back(reading.ranges_m[i]);
  }
  reading.ranges_m = std::move(ranges_m);
  reading.sensor = ring.sonars;
  return reading;
}

std::optional<SonarTrajectory> correct_single_beams(std::vector<RangeReading> readings,
                                                    std::span<const Pose2> matched,
                                                    const DriveDirectionOptions& directions,
                                                    SonarTrajectoryOptions options,
                                                    const std::function<void()>& before_attempt,
                                                    int jobs) {
  if (readings.size() != matched.size()) {
    throw std::invalid_argument("correct_single_beams: not one pose a reading");
  }
  if (readings.empty()) return std::nullopt;
  options.segments.max_range_m = kFarthestM;
  const double lag_s = lag_of(readings, matched);
  make_timely(readings, lag_s);
  const DriveDirections driven = find_drive_directions(readings, directions);
  SonarTrajectory found = correct_sonar_trajectory(with_turns_of(matched, readings), driven,
                                                   options, before_attempt, jobs);
  const DrivenPath path = driven_path(readings, driven, {});
  // Along the sweeps, which are smoothest from one reading to the next: along each trajectory by
  // itself the smoother one has the more of them.
  const std::vector<WallSegment> walls =
      wall_segments(readings, matched, path.path_m, options.segments, jobs);
  const auto score_m = [&](std::span<const Pose2> poses) {
    return score_of(contradiction_of(readings, poses, path.path_m, walls, {}));
  };
  const double matched_m = score_m(matched);
  if (score_m(found.map_from_robot) <= matched_m + kBetterThanSweeps * std::abs(matched_m)) {
    return std::nullopt;
  }
  found.habits = habits_between(path.odom_from_robot, found.map_from_robot, true);
  found.habits.lag_s = lag_s;
  return found;
}

}  // namespace roomatlas
