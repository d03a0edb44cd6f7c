// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/mission/resample.hpp"

#include "roomatlas/core/median.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace roomatlas {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// A ray's end as the other sensor sees it.
struct SeenEnd {
  double bearing_rad = 0.0;
  double range_m = 0.0;
  Point2 end = Point2::Zero();
  Echo echo = Echo::unknown;
};

/// Fills the beams of a sensor whose beams are evenly spaced.
class Resampler {
 public:
  explicit Resampler(const RangeSensor& onto)
      : onto_(onto), ranges_m_(onto.robot_from_beam.size(), kUnknown) {
    const auto beams = static_cast<double>(onto.robot_from_beam.size());
    first_rad_ = onto.robot_from_beam.front().theta_rad;
    step_rad_ = wrap_angle(onto.robot_from_beam[1].theta_rad - first_rad_);
    middle_rad_ = first_rad_ + step_rad_ * (beams - 1.0) / 2.0;
    turn_ = std::llround(2.0 * kPi / step_rad_);
  }

  [[nodiscard]] SeenEnd seen(const SweepRay& ray) const {
    const Point2 off = ray.end - onto_.robot_from_beam.front().position();
    return {std::atan2(off.y(), off.x()), off.norm(), ray.end, ray.echo};
  }

  void fill_between(const SeenEnd& from, const SeenEnd& to) {
    constexpr double kWidestSteps = 3.5;  // farther apart: between them nothing was measured
    const double turn_rad = wrap_angle(to.bearing_rad - from.bearing_rad);
    if (turn_rad < 0.0 || turn_rad > kWidestSteps * std::max(step_rad_, typical_rad_)) return;
    const double place = place_of(from.bearing_rad);
    const double end = place + turn_rad / step_rad_;
    for (double beam = std::ceil(place); beam <= end; beam += 1.0) {
      const double share = turn_rad > 0.0 ? (beam - place) * step_rad_ / turn_rad : 0.0;
      fill(static_cast<std::int64_t>(beam), from, to, share);
    }
  }
  /// Where no pair enclosed a beam: an end beside it, at the borders of the sweep.
  void fill_beside(const SeenEnd& seen) {
    const double place = place_of(seen.bearing_rad);
    const double beam = std::round(place);
    if (std::abs(place - beam) <= 0.5) fill(static_cast<std::int64_t>(beam), seen, seen, 0.0);
  }
  void set_typical(double step_rad) { typical_rad_ = step_rad; }
  [[nodiscard]] std::vector<float> taken() { return std::move(ranges_m_); }

 private:
  [[nodiscard]] double place_of(double bearing_rad) const {
    return (wrap_angle(bearing_rad - middle_rad_) + middle_rad_ - first_rad_) / step_rad_;
  }

  void fill(std::int64_t beam, const SeenEnd& from, const SeenEnd& to, double share) {
    for (const std::int64_t at : {beam, beam + turn_, beam - turn_}) {
      if (at < 0 || at >= static_cast<std::int64_t>(ranges_m_.size())) continue;
      const auto index = static_cast<std::size_t>(at);
      if (is_filled_[index]) continue;
      is_filled_[index] = true;
      ranges_m_[index] = range_on(index, from, to, share);
    }
  }

  [[nodiscard]] float range_on(std::size_t beam, const SeenEnd& from, const SeenEnd& to,
                               double share) const {
    if (from.echo == Echo::surface && to.echo == Echo::surface) {
      if (const auto met_m = meeting(beam, from, to)) return as_range(*met_m);
    }
    const SeenEnd& nearer = share <= 0.5 ? from : to;
    if (nearer.echo == Echo::surface) return as_range(nearer.range_m);
    return nearer.echo == Echo::nothing ? static_cast<float>(onto_.max_range_m) : kUnknown;
  }

  [[nodiscard]] float as_range(double range_m) const {
    return static_cast<float>(std::min(range_m, onto_.max_range_m));
  }

  /// Where the beam meets the line between two ends; nothing where they are no one surface.
  [[nodiscard]] std::optional<double> meeting(std::size_t beam, const SeenEnd& from,
                                              const SeenEnd& to) const {
    constexpr double kApartM = 0.1;      // farther apart in range they are two surfaces ...
    constexpr double kApartShare = 0.1;  // ... or more than this share of the range
    const double apart_m = std::abs(from.range_m - to.range_m);
    if (apart_m > std::max(kApartM, kApartShare * std::min(from.range_m, to.range_m))) {
      return std::nullopt;
    }
    const Pose2& pose = onto_.robot_from_beam[beam];
    const Point2 ray = direction(pose.theta_rad);
    const Point2 along = to.end - from.end;
    const double across = ray.x() * along.y() - ray.y() * along.x();
    const Point2 off = from.end - pose.position();
    const double range_m = (off.x() * along.y() - off.y() * along.x()) / across;
    const bool between = range_m >= std::min(from.range_m, to.range_m) - kApartM &&
                         range_m <= std::max(from.range_m, to.range_m) + kApartM;
    if (!between) return std::nullopt;  // also where the two are one point
    return range_m;
  }

  const RangeSensor& onto_;
  std::vector<float> ranges_m_;
  std::vector<bool> is_filled_ = std::vector<bool>(ranges_m_.size(), false);
  double first_rad_ = 0.0;
  double step_rad_ = 1.0;
  double middle_rad_ = 0.0;
  double typical_rad_ = 0.0;
  std::int64_t turn_ = 1;
};

}  // namespace

std::vector<float> resampled(const std::vector<SweepRay>& rays, const RangeSensor& onto) {
  if (onto.robot_from_beam.size() < 2 || rays.empty()) {
    return std::vector<float>(onto.robot_from_beam.size(), kUnknown);
  }
  Resampler resampler(onto);
  std::vector<SeenEnd> seen;
  seen.reserve(rays.size());
  for (const SweepRay& ray : rays) seen.push_back(resampler.seen(ray));
  std::vector<double> steps_rad;
  for (std::size_t i = 1; i < seen.size(); ++i) {
    steps_rad.push_back(std::abs(wrap_angle(seen[i].bearing_rad - seen[i - 1].bearing_rad)));
  }
  if (!steps_rad.empty()) resampler.set_typical(median(std::move(steps_rad)));
  for (std::size_t i = 1; i < seen.size(); ++i) resampler.fill_between(seen[i - 1], seen[i]);
  resampler.fill_between(seen.back(), seen.front());  // of a full turn
  for (const SeenEnd& end : seen) resampler.fill_beside(end);
  return resampler.taken();
}

}  // namespace roomatlas
