// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/odometry/drive_directions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "drives.hpp"

namespace roomatlas {
namespace {

constexpr double kLeastRangeM = 0.2;  // nearer, a sonar hears its own ringing
constexpr double kMostRangeM = 4.0;   // farther returns come from many things at once
constexpr double kSameThingM = 0.3;   // a return farther off under both motions tells nothing
constexpr double kBesideBeamRad = radians(2.0);  // of a point from a beam without a cone
constexpr double kLeastStepS = 0.15;  // shorter steps of a fast sensor would all look like stops
constexpr double kBackwardM = -0.01;  // a step that odometry reports as backward; nearer 0 it may
                                      // be a turn about another point than the robot's centre
constexpr int kSignedSteps = 3;       // of these show that it does; fewer may be a jump of the
                                      // encoders
constexpr std::size_t kBefore = 3;    // readings of the stop that are compared too: where nothing
constexpr std::size_t kBehind = 2;    // moved, a short drive has more pairs

/// Readings of one sensor, not too close in time.
struct Keys {
  std::vector<const RangeReading*> readings;
  std::vector<std::size_t> number;  ///< of each in the mission
};
using Readings = std::vector<const RangeReading*>;

bool is_usable(double range_m, const RangeSensor& sensor) {
  return range_m > kLeastRangeM && range_m < std::min(kMostRangeM, sensor.max_range_m);
}

Keys keys_of(std::span<const RangeReading> mission) {
  std::map<const RangeSensor*, std::size_t> count;
  for (const RangeReading& reading : mission) ++count[reading.sensor.get()];
  // the sensor that is read most often; of equals, the one that comes first
  std::size_t most = 0;
  for (const auto& [sensor, readings] : count) most = std::max(most, readings);
  const auto chosen = std::find_if(mission.begin(), mission.end(), [&](const auto& reading) {
    return count[reading.sensor.get()] == most;
  });
  Keys keys;
  for (std::size_t i = 0; i < mission.size(); ++i) {
    if (mission[i].sensor != chosen->sensor) continue;
    const bool soon =
        !keys.readings.empty() &&
        std::abs(mission[i].timestamp_s - keys.readings.back()->timestamp_s) < kLeastStepS;
    if (soon) continue;
    keys.readings.push_back(&mission[i]);
    keys.number.push_back(i);
  }
  return keys;
}

Pose2 step_to(const Readings& readings, std::size_t i) {
  return reported_step(*readings[i - 1], *readings[i]);
}

/// By how much the range heard in the direction of a point differs from its distance; nothing
/// where no cone with a range looks there.
std::optional<double> excess_m(const RangeReading& reading, const Point2& point_robot) {
  const RangeSensor& sensor = *reading.sensor;
  std::optional<double> excess;
  double nearest = std::max(sensor.half_cone_rad, kBesideBeamRad);
  for (std::size_t i = 0; i < sensor.robot_from_beam.size(); ++i) {
    const double range_m = reading.ranges_m[i];
    if (!(range_m > kLeastRangeM) || !std::isfinite(range_m)) continue;
    const Pose2& beam = sensor.robot_from_beam[i];
    const Point2 to = point_robot - beam.position();
    const double off = std::abs(wrap_angle(std::atan2(to.y(), to.x()) - beam.theta_rad));
    if (off > nearest) continue;
    nearest = off;
    excess = to.norm() - range_m;
  }
  return excess;
}

/// Log odds of reversed against reported, of one pair of readings.
double log_odds(const RangeReading& earlier, const RangeReading& later,
                const std::array<Pose2, 2>& later_from_earlier,
                const DriveDirectionOptions& options) {
  double odds = 0.0;
  for (std::size_t i = 0; i < earlier.ranges_m.size(); ++i) {
    const double range_m = earlier.ranges_m[i];
    if (!is_usable(range_m, *earlier.sensor)) continue;
    const Point2 hit = earlier.sensor->robot_from_beam[i] * Point2(range_m, 0.0);
    const auto reported = excess_m(later, later_from_earlier[0] * hit);
    const auto against = excess_m(later, later_from_earlier[1] * hit);
    if (!reported || !against) continue;
    if (std::min(std::abs(*reported), std::abs(*against)) > kSameThingM) continue;
    const auto log_likelihood = [&](double excess) {
      const double sigmas = excess / options.range_sigma_m;
      return std::log(options.mission.other_share + std::exp(-sigmas * sigmas / 2.0));
    };
    odds += log_likelihood(*against) - log_likelihood(*reported);
  }
  return odds;
}

/// What speaks for a drive being reversed.
struct Evidence {
  double log_odds = 0.0;
  int pairs = 0;  ///< that tell

  [[nodiscard]] bool is_clear(const DriveDirectionOptions& options) const {
    return log_odds >= options.mission.clear_log_odds_per_pair * pairs;
  }
};

/// A drive: readings [first, last] around two stops, and their poses under both motions.
class Drive {
 public:
  Drive(const Readings& readings, std::size_t first, std::size_t last) : readings_(readings) {
    path_m_.push_back(0.0);
    for (auto& poses : poses_) poses.emplace_back();
    for (std::size_t i = first + 1; i <= last; ++i) {
      const Pose2 step = step_to(readings, i);
      poses_[0].push_back(poses_[0].back() * step);
      poses_[1].push_back(poses_[1].back() * driven(step, DriveDirection::reversed));
      path_m_.push_back(path_m_.back() + step.position().norm());
    }
    first_ = first;
  }

  [[nodiscard]] Evidence of_reverse(const DriveDirectionOptions& options) const {
    Evidence evidence;
    for (std::size_t u = 0; u < path_m_.size(); ++u) {
      for (std::size_t v = u + 1; v < path_m_.size(); ++v) {
        const double apart_m = path_m_[v] - path_m_[u];
        if (apart_m > options.max_apart_m) break;
        if (!can_tell(apart_m, options)) continue;
        const std::array v_from_u = {inverse(poses_[0][v]) * poses_[0][u],
                                     inverse(poses_[1][v]) * poses_[1][u]};
        if (std::abs(v_from_u[0].theta_rad) > options.mission.max_turn_rad) break;
        const double of_pair =
            log_odds(*readings_[first_ + u], *readings_[first_ + v], v_from_u, options);
        if (of_pair == 0.0) continue;
        evidence.log_odds += options.mission.independence * of_pair;
        ++evidence.pairs;
      }
    }
    return evidence;
  }

 private:
  const Readings& readings_;
  std::size_t first_ = 0;
  std::array<std::vector<Pose2>, 2> poses_;  ///< in the frame of the first: reported, reversed
  std::vector<double> path_m_;
};

bool reports_backward_steps(const Readings& readings) {
  int backward = 0;
  for (std::size_t i = 1; i < readings.size(); ++i) {
    if (step_to(readings, i).x_m < kBackwardM) ++backward;
  }
  return backward >= kSignedSteps;
}

/// Keys [first, end) of a drive, and which way it went.
struct DecidedDrive {
  std::size_t first = 0;
  std::size_t end = 0;
  Evidence evidence;
  DriveDirection direction = DriveDirection::as_reported;
};

std::vector<DecidedDrive> drives_of(const Readings& readings,
                                    const DriveDirectionOptions& options) {
  const std::size_t count = readings.size();
  const auto moves = [&](std::size_t k) {
    return k < count && !is_stop(step_to(readings, k), options);
  };
  std::vector<DecidedDrive> drives;
  for (std::size_t first = 1; first < count; ++first) {
    if (!moves(first)) continue;
    DecidedDrive drive;
    drive.first = drive.end = first;
    while (moves(drive.end)) ++drive.end;
    const std::size_t from = first > kBefore ? first - kBefore : 0;
    drive.evidence =
        Drive(readings, from, std::min(count - 1, drive.end + kBehind)).of_reverse(options);
    drive.direction = decided(drive.evidence.log_odds, options);
    first = drive.end;
    drives.push_back(drive);
  }
  return drives;
}

/// What a mission's drives say of each other. Evidence of pairs that say little each may be of one
/// thing that all of them take for another: it reverses a drive only where more are clearly
/// reversed. A robot that clearly drove forwards often enough, and never clearly backwards, does so
/// where nothing tells.
void judge_together(const DriveDirectionOptions& options, std::vector<DecidedDrive>& drives) {
  const auto is_unclear = [&](const DecidedDrive& drive) {
    return drive.direction == DriveDirection::reversed && !drive.evidence.is_clear(options);
  };
  const auto count_of = [&](DriveDirection direction) {
    return std::count_if(drives.begin(), drives.end(),
                         [&](const DecidedDrive& drive) { return drive.direction == direction; });
  };
  const auto unclear = std::count_if(drives.begin(), drives.end(), is_unclear);
  const auto clear = count_of(DriveDirection::reversed) - unclear;
  if (clear > unclear) return;
  const bool is_forwards =
      clear == 0 && count_of(DriveDirection::as_reported) >= options.mission.forward_drives;
  for (DecidedDrive& drive : drives) {
    if (is_unclear(drive)) drive.direction = DriveDirection::undecided;
    if (is_forwards) drive.direction = DriveDirection::as_reported;
  }
}

/// Marks the steps of a drive; those into and out of the stops go the same way.
void mark(std::span<const RangeReading> mission, const Keys& keys, const DecidedDrive& drive,
          DriveDirections& result) {
  const std::size_t begin = std::max<std::size_t>(2, drive.first) - 2;
  const std::size_t last = keys.number[std::min(keys.readings.size() - 1, drive.end)];
  for (std::size_t i = keys.number[begin] + 1; i <= last; ++i) {
    result.of_step[i] = std::max(result.of_step[i], drive.direction);
    if (drive.direction != DriveDirection::undecided) continue;
    result.undecided_m[i] =
        (mission[i].odom_from_robot.position() - mission[i - 1].odom_from_robot.position()).norm();
  }
}

}  // namespace

DriveDirections find_drive_directions(std::span<const RangeReading> readings,
                                      const DriveDirectionOptions& options) {
  DriveDirections result;
  result.of_step.assign(readings.size(), DriveDirection::as_reported);
  result.undecided_m.assign(readings.size(), 0.0);
  if (readings.empty()) return result;
  const Keys keys = keys_of(readings);
  result.odometry_is_signed = reports_backward_steps(keys.readings);
  if (!options.find_reverse || result.odometry_is_signed) return result;
  std::vector<DecidedDrive> drives = drives_of(keys.readings, options);
  judge_together(options, drives);
  for (const DecidedDrive& drive : drives) {
    if (drive.direction == DriveDirection::reversed) ++result.drives_reversed;
    mark(readings, keys, drive, result);
  }
  // so far by step: summed up along the mission
  std::partial_sum(result.undecided_m.begin(), result.undecided_m.end(),
                   result.undecided_m.begin());
  return result;
}

}  // namespace roomatlas
