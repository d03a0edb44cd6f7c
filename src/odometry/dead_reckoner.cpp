// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/odometry/dead_reckoner.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace roomatlas {
namespace {

constexpr double kMaxComparedM = 8.0;  // farther returns move too much with the heading
constexpr std::size_t kBeamsCompared = 60;
constexpr double kIndependentBeams = 8.0;  // neighbouring beams see the same wall
constexpr double kWorstSigmas = 3.0;       // a return on something else costs no more than this
constexpr std::size_t kMaxWaiting = 64;    // an interval is decided long before
constexpr double kDecidedLogOdds = 60.0;   // enough evidence, either way, to stop waiting

bool is_return(const RangeReading& reading, std::size_t beam) {
  const double range_m = reading.ranges_m[beam];
  return std::isfinite(range_m) && range_m > 0.0 && range_m < reading.sensor->max_range_m &&
         range_m < kMaxComparedM;
}

Pose2 step_between(const RangeReading& from, const RangeReading& to) {
  return inverse(from.odom_from_robot) * to.odom_from_robot;
}

Pose2 reversed(const Pose2& step) { return {-step.x_m, -step.y_m, step.theta_rad}; }

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
  constexpr double kMaxOffRad = radians(2.0);
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
                                const DeadReckonerOptions& options) {
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
  constexpr int kMinCompared = 4;
  if (compared < kMinCompared) return std::nullopt;
  return sum / compared;
}

}  // namespace

double reverse_log_odds(const RangeReading& earlier, const RangeReading& later,
                        const DeadReckonerOptions& options) {
  const Pose2 step = step_between(earlier, later);
  const auto reported = agreement(earlier, later, step, options);
  const auto against = agreement(earlier, later, reversed(step), options);
  return reported && against ? kIndependentBeams * (*against - *reported) : 0.0;
}

bool DeadReckoner::is_clearly_reversed() const {
  return log_odds_ > options_.flip_log_odds && log_odds_ > options_.flip_log_odds_per_pair * pairs_;
}

std::vector<DeadReckoned> DeadReckoner::release(bool is_reversed) {
  std::vector<DeadReckoned> released;
  for (RangeReading& reading : waiting_) {
    if (last_released_) {
      const Pose2 step = step_between(*last_released_, reading);
      reckoned_from_last_ = reckoned_from_last_ * (is_reversed ? reversed(step) : step);
    } else {
      reckoned_from_last_ = reading.odom_from_robot;
    }
    last_released_ = reading;
    released.push_back({std::move(reading), reckoned_from_last_});
  }
  waiting_.clear();
  return released;
}

std::vector<DeadReckoned> DeadReckoner::add(const RangeReading& reading) {
  const RangeReading* previous = !waiting_.empty() ? &waiting_.back()
                                 : last_released_  ? &*last_released_
                                                   : nullptr;
  const Pose2 step = previous != nullptr ? step_between(*previous, reading) : Pose2{};
  const bool stopped = step.position().norm() < options_.stop_step_m;
  std::vector<DeadReckoned> released;
  if (stopped || step.x_m < 0.0 || !options_.find_reverse) {
    released = finish();  // the interval before ends here; this step goes the reported way
    waiting_.push_back(reading);
    std::vector<DeadReckoned> now = release(false);
    released.insert(released.end(), now.begin(), now.end());
    return released;
  }
  if (!decided_) {
    const auto compare = [&](const RangeReading& earlier) {
      const double apart_m = step_between(earlier, reading).position().norm();
      if (apart_m < options_.min_apart_m || apart_m > options_.max_apart_m) return;
      log_odds_ += reverse_log_odds(earlier, reading, options_);
      ++pairs_;
    };
    if (last_released_) compare(*last_released_);  // where the interval began
    for (const RangeReading& earlier : waiting_) compare(earlier);
  }
  waiting_.push_back(reading);
  const bool waited_enough = waiting_.size() >= kMaxWaiting;
  if (!decided_ && (std::abs(log_odds_) > kDecidedLogOdds || waited_enough)) {
    decided_ = is_clearly_reversed();
    if (*decided_) ++intervals_reversed_;
  }
  return decided_ ? release(*decided_) : released;
}

std::vector<DeadReckoned> DeadReckoner::finish() {
  const bool is_reversed = decided_.value_or(is_clearly_reversed());
  if (!decided_ && is_reversed) ++intervals_reversed_;
  decided_.reset();
  log_odds_ = 0.0;
  pairs_ = 0;
  return release(is_reversed);
}

}  // namespace roomatlas
