// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/sonar/wall_segments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "roomatlas/core/for_each_index.hpp"

namespace roomatlas {
namespace {

constexpr std::size_t kSeed = 4;          // returns that a segment grows from
constexpr double kSeedMaxPathM = 1.2;     // of a seed; a longer one has gaps
constexpr double kSeedMinPathM = 0.12;    // a shorter one shows no direction
constexpr double kSigmaShare = 0.7;       // of the tolerance: largest sigma of a segment
constexpr std::size_t kRefitAlways = 10;  // returns up to which each one is fitted anew
constexpr std::size_t kRefitEvery = 4;    // beyond them; a fit costs more than it changes

/// Readings of one sensor that are far enough apart to tell anything new.
using KeyReadings = std::vector<std::size_t>;

std::map<const RangeSensor*, KeyReadings> key_readings(std::span<const RangeReading> readings,
                                                       std::span<const Pose2> map_from_robot,
                                                       const WallSegmentOptions& options) {
  std::map<const RangeSensor*, KeyReadings> keys;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (readings[i].sensor->kind != SensorKind::sonar) continue;
    KeyReadings& of_sensor = keys[readings[i].sensor.get()];
    if (!of_sensor.empty()) {
      const Pose2& last = map_from_robot[of_sensor.back()];
      const Pose2& now = map_from_robot[i];
      const bool moved = (now.position() - last.position()).norm() > options.step_m ||
                         std::abs(wrap_angle(now.theta_rad - last.theta_rad)) > options.turn_rad;
      if (!moved) continue;
    }
    of_sensor.push_back(i);
  }
  return keys;
}

/// What one sonar heard along the mission, at the key readings.
struct Beam {
  const KeyReadings* keys = nullptr;
  std::vector<ConeReturn> returns;  ///< one a key reading; range 0 where there is no usable return
  double half_cone_rad = 0.0;
  double max_range_m = 0.0;
};

/// @param places those of the key readings, as transforms
Beam heard_by(std::size_t beam, const KeyReadings& keys, std::span<const RangeReading> readings,
              std::span<const Pose2> map_from_robot, std::span<const PointTransform> places,
              const WallSegmentOptions& options) {
  const RangeSensor& sensor = *readings[keys.front()].sensor;
  Beam result{&keys, {}, sensor.half_cone_rad, std::min(options.max_range_m, sensor.max_range_m)};
  result.returns.reserve(keys.size());
  const ConeReturn nothing;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const std::size_t i = keys[k];
    const double range_m = readings[i].ranges_m[beam];
    const bool usable = range_m > options.min_range_m && range_m < result.max_range_m;
    if (!usable) {
      result.returns.push_back(nothing);
      continue;
    }
    const Pose2 pose = places[k].pose(map_from_robot[i], sensor.robot_from_beam[beam]);
    result.returns.push_back({pose.position(), pose.theta_rad, range_m});
  }
  return result;
}

/// Grows segments along one beam.
class Grower {
 public:
  Grower(const Beam& beam, std::span<const Pose2> map_from_robot, std::span<const double> path_m,
         const WallSegmentOptions& options)
      : beam_(beam), map_from_robot_(map_from_robot), path_m_(path_m), options_(options) {}

  void grow_all(std::vector<WallSegment>& segments) {
    for (std::size_t from = 0; from < beam_.returns.size();) {
      const std::size_t past = grow(from) ? last_ + 1 : from + 1;
      if (past > from + 1) {
        if (const auto segment = finished()) {
          segments.push_back(*segment);
          from = past;
          continue;
        }
      }
      ++from;
    }
  }

 private:
  [[nodiscard]] std::size_t reading(std::size_t k) const { return (*beam_.keys)[k]; }
  [[nodiscard]] bool within(std::size_t from, std::size_t k, double max_path_m) const {
    return path_m_[reading(k)] - path_m_[reading(from)] <= max_path_m &&
           std::abs(wrap_angle(map_from_robot_[reading(k)].theta_rad -
                               map_from_robot_[reading(from)].theta_rad)) <= options_.max_turn_rad;
  }
  void take(std::size_t k) {
    taken_.push_back(beam_.returns[k]);
    keys_.push_back(k);
  }
  bool fit() {
    const auto line = fit_line(taken_, beam_.half_cone_rad);
    if (line) line_ = *line;
    return line.has_value();
  }

  /// From the returns that begin at a key reading; false where they are no wall.
  bool grow(std::size_t from) {
    taken_.clear();
    keys_.clear();
    std::size_t k = from;
    for (; k < beam_.returns.size() && taken_.size() < kSeed; ++k) {
      if (beam_.returns[k].range_m == 0.0 || !within(from, k, kSeedMaxPathM)) return false;
      take(k);
    }
    if (taken_.size() < kSeed || path_m_[reading(k - 1)] - path_m_[reading(from)] < kSeedMinPathM) {
      return false;
    }
    if (!fit() || line_.sigma_m > options_.tolerance_m * kSigmaShare) return false;
    last_ = k - 1;
    int misses = 0;
    for (; k < beam_.returns.size() && within(from, k, options_.max_path_m); ++k) {
      const ConeReturn& one = beam_.returns[k];
      const auto expected_m = one.range_m > 0.0 ? range_to_line(one, beam_.half_cone_rad, line_)
                                                : std::optional<double>();
      if (!expected_m || std::abs(*expected_m - one.range_m) >= options_.tolerance_m) {
        if (++misses > options_.max_misses) break;
        continue;
      }
      take(k);
      last_ = k;
      misses = 0;
      const bool refit = taken_.size() < kRefitAlways || taken_.size() % kRefitEvery == 0;
      if (refit && !fit()) return false;
    }
    return fit();
  }

  [[nodiscard]] std::optional<WallSegment> finished() const {
    const Point2& normal = line_.normal;
    const Point2 tangent(-normal.y(), normal.x());
    double least = std::numeric_limits<double>::max();
    double most = std::numeric_limits<double>::lowest();
    for (const ConeReturn& one : taken_) {
      const double at = tangent.dot(foot_of(one, beam_.half_cone_rad, line_));
      least = std::min(least, at);
      most = std::max(most, at);
    }
    const double driven_m = path_m_[reading(keys_.back())] - path_m_[reading(keys_.front())];
    if (std::ssize(taken_) < options_.min_returns || most - least < options_.min_length_m ||
        driven_m < options_.min_path_m || line_.sigma_m > options_.tolerance_m * kSigmaShare) {
      return std::nullopt;
    }
    WallSegment segment;
    segment.reading = reading(keys_[keys_.size() / 2]);
    const Pose2& pose = map_from_robot_[segment.reading];
    segment.normal_rad = wrap_angle(line_.normal_rad - pose.theta_rad);
    segment.middle_robot =
        inverse(pose) * Point2(line_.offset_m * normal + (least + most) / 2.0 * tangent);
    segment.length_m = most - least;
    segment.sigma_m = line_.sigma_m;
    return segment;
  }

  const Beam& beam_;
  std::span<const Pose2> map_from_robot_;
  std::span<const double> path_m_;
  const WallSegmentOptions& options_;
  std::vector<ConeReturn> taken_;
  std::vector<std::size_t> keys_;  ///< of `taken_`
  ConeLine line_;
  std::size_t last_ = 0;  ///< key of the last return taken
};

}  // namespace

std::vector<WallSegment> wall_segments(std::span<const RangeReading> readings,
                                       std::span<const Pose2> map_from_robot,
                                       std::span<const double> path_m,
                                       const WallSegmentOptions& options, int jobs) {
  std::vector<WallSegment> segments;
  for (const auto& entry : key_readings(readings, map_from_robot, options)) {
    const auto& sensor = entry.first;
    const auto& keys = entry.second;
    std::vector<PointTransform> places;
    places.reserve(keys.size());
    for (const std::size_t i : keys) places.emplace_back(map_from_robot[i]);
    const auto along_beam = [&](std::size_t beam) {
      std::vector<WallSegment> of_beam;
      const Beam heard = heard_by(beam, keys, readings, map_from_robot, places, options);
      Grower(heard, map_from_robot, path_m, options).grow_all(of_beam);
      return of_beam;
    };
    for (const auto& of_beam :
         results_of<std::vector<WallSegment>>(sensor->robot_from_beam.size(), jobs, along_beam)) {
      segments.insert(segments.end(), of_beam.begin(), of_beam.end());
    }
  }
  // by reading, then by content: the sensors' addresses must not decide the order
  std::sort(segments.begin(), segments.end(), [](const WallSegment& a, const WallSegment& b) {
    if (a.reading != b.reading) return a.reading < b.reading;
    return a.normal_rad < b.normal_rad;
  });
  return segments;
}

}  // namespace roomatlas
