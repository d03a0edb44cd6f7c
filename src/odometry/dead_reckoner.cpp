// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/odometry/dead_reckoner.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "drives.hpp"

namespace roomatlas {
namespace {

constexpr double kMaxComparedM = 8.0;        // farther returns move too much with the heading
constexpr std::size_t kBeamsCompared = 60;   // of a sweep: more cost time and say the same
constexpr double kIndependentBeams = 8.0;    // neighbouring beams see the same wall
constexpr double kWorstSigmas = 3.0;         // a return on something else costs no more than this
constexpr std::size_t kMaxWaiting = 64;      // readings; a drive is decided long before. More holds
                                             // the recorder up
constexpr double kDecidedLogOdds = 60.0;     // enough evidence, either way, to stop waiting
constexpr double kMaxOffRad = radians(2.0);  // of a point from a beam without a cone: as far as
                                             // between two beams of the coarsest sweeps
constexpr int kMinCompared = 4;              // returns; fewer say nothing of a pair

bool is_return(const RangeReading& reading, std::size_t beam) {
  const double range_m = reading.ranges_m[beam];
  return std::isfinite(range_m) && range_m > 0.0 && range_m < reading.sensor->max_range_m &&
         range_m < kMaxComparedM;
}

/// How a point is seen.
struct Sighting {
  std::size_t beam = 0;
  double range_m = 0.0;
};

/// Where a sensor's beams look, in the robot's frame.
std::vector<Point2> directions_of(const RangeSensor& sensor) {
  std::vector<Point2> directions;
  for (const Pose2& beam : sensor.robot_from_beam) directions.push_back(direction(beam.theta_rad));
  return directions;
}

/// The beam that looks nearest to a point, and how far away it is along it; nothing when the
/// point lies outside of every beam.
std::optional<Sighting> sighting_of(const RangeSensor& sensor, std::span<const Point2> directions,
                                    const Point2& point_robot) {
  double best_cosine = std::cos(std::max(sensor.half_cone_rad, kMaxOffRad));
  std::optional<Sighting> best;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Point2 to_point = point_robot - sensor.robot_from_beam[i].position();
    const double range_m = to_point.norm();
    const double cosine = directions[i].dot(to_point) / range_m;
    if (!(cosine >= best_cosine)) continue;
    best_cosine = cosine;
    best = Sighting{i, range_m};
  }
  return best;
}

/// Mean log likelihood of `later`'s returns under a motion; nothing when too few can be compared.
std::optional<double> agreement(const RangeReading& earlier, const RangeReading& later,
                                const Pose2& earlier_from_later,
                                const DriveDirectionOptions& options) {
  const std::size_t beams = later.ranges_m.size();
  const std::size_t stride = std::max<std::size_t>(1, beams / kBeamsCompared);
  const std::vector<Point2> directions = directions_of(*earlier.sensor);
  double sum = 0.0;
  int compared = 0;
  for (std::size_t i = 0; i < beams; i += stride) {
    if (!is_return(later, i)) continue;
    const Point2 hit = later.sensor->robot_from_beam[i] * Point2(later.ranges_m[i], 0.0);
    const auto seen = sighting_of(*earlier.sensor, directions, earlier_from_later * hit);
    if (!seen || !is_return(earlier, seen->beam)) continue;
    const double sigmas = (seen->range_m - earlier.ranges_m[seen->beam]) / options.range_sigma_m;
    sum -= std::min(sigmas * sigmas, kWorstSigmas * kWorstSigmas) / 2.0;
    ++compared;
  }
  if (compared < kMinCompared) return std::nullopt;
  return sum / compared;
}

}  // namespace

double reverse_log_odds(const RangeReading& earlier, const RangeReading& later,
                        const DriveDirectionOptions& options) {
  const Pose2 step = reported_step(earlier, later);
  const auto reported = agreement(earlier, later, step, options);
  const auto against = agreement(earlier, later, driven(step, DriveDirection::reversed), options);
  return reported && against ? kIndependentBeams * (*against - *reported) : 0.0;
}

DriveDirection DeadReckoner::decide() const {
  const DriveDirection direction = decided(log_odds_, options_);
  const bool is_clear = log_odds_ > options_.stream.flip_log_odds_per_pair * pairs_;
  return direction == DriveDirection::reversed && !is_clear ? DriveDirection::undecided : direction;
}

std::vector<DeadReckoned> DeadReckoner::release(DriveDirection direction) {
  std::vector<DeadReckoned> released;
  for (RangeReading& reading : waiting_) {
    if (last_released_) {
      const Pose2 step = reported_step(*last_released_, reading);
      reckoned_from_last_ = reckoned_from_last_ * driven(step, direction);
    } else {
      reckoned_from_last_ = reading.odom_from_robot;
    }
    last_released_ = reading;
    released.push_back({std::move(reading), reckoned_from_last_});
  }
  waiting_.clear();
  return released;
}

void DeadReckoner::compare(const RangeReading& earlier, const RangeReading& later) {
  if (!can_tell(reported_step(earlier, later).position().norm(), options_)) return;
  log_odds_ += reverse_log_odds(earlier, later, options_);
  ++pairs_;
}

std::vector<DeadReckoned> DeadReckoner::add(const RangeReading& reading) {
  const RangeReading* previous = !waiting_.empty() ? &waiting_.back()
                                 : last_released_  ? &*last_released_
                                                   : nullptr;
  const Pose2 step = previous != nullptr ? reported_step(*previous, reading) : Pose2{};
  if (is_stop(step, options_) || step.x_m < 0.0 || !options_.find_reverse) {
    std::vector<DeadReckoned> released = finish();  // the drive before ends here
    waiting_.push_back(reading);
    std::vector<DeadReckoned> now = release(DriveDirection::as_reported);
    std::move(now.begin(), now.end(), std::back_inserter(released));
    return released;
  }
  if (!decided_) {
    if (last_released_) compare(*last_released_, reading);  // where the drive began
    for (const RangeReading& earlier : waiting_) compare(earlier, reading);
  }
  waiting_.push_back(reading);
  const bool waited_enough = waiting_.size() >= kMaxWaiting;
  if (!decided_ && (std::abs(log_odds_) > kDecidedLogOdds || waited_enough)) {
    decided_ = decide();
    if (*decided_ == DriveDirection::reversed) ++drives_reversed_;
  }
  return decided_ ? release(*decided_) : std::vector<DeadReckoned>();
}

std::vector<DeadReckoned> DeadReckoner::finish() {
  const DriveDirection direction = decided_.value_or(decide());
  if (!decided_ && direction == DriveDirection::reversed) ++drives_reversed_;
  decided_.reset();
  log_odds_ = 0.0;
  pairs_ = 0;
  return release(direction);
}

}  // namespace roomatlas
