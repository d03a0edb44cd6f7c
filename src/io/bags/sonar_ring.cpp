// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/sonar_ring.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomatlas::io {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// Infinite for nothing within range (REP 117).
float range_of(const RangeMessage& message) {
  const double range_m = static_cast<double>(message.range_m);
  if (std::isnan(range_m) || range_m <= 0.0 || range_m < message.min_range_m) return kUnknown;
  const bool has_max = std::isfinite(message.max_range_m) && message.max_range_m > 0.0;
  if (has_max && range_m >= message.max_range_m) return std::numeric_limits<float>::max();
  return std::isinf(range_m) ? std::numeric_limits<float>::max() : message.range_m;
}

}  // namespace

SonarRing::SonarRing(std::vector<Name> sonars)
    : sonars_(std::move(sonars)), heard_(sonars_.size(), false) {
  round_.ranges_m.assign(sonars_.size(), kUnknown);
}

SonarRing::Round SonarRing::taken() {
  Round round = round_;
  round_.ranges_m.assign(sonars_.size(), kUnknown);
  heard_.assign(sonars_.size(), false);
  return round;
}

std::optional<SonarRing::Round> SonarRing::add(std::size_t topic, const RangeMessage& message,
                                               std::int64_t stamp_ns) {
  const auto found = std::find(sonars_.begin(), sonars_.end(), Name{topic, message.header.frame});
  if (found == sonars_.end()) {
    ++strangers_;
    return std::nullopt;
  }
  const auto beam = static_cast<std::size_t>(found - sonars_.begin());
  std::optional<Round> ended;
  if (heard_[beam]) ended = taken();
  heard_[beam] = true;
  round_.stamp_ns = stamp_ns;
  round_.ranges_m[beam] = range_of(message);
  if (std::isfinite(message.field_of_view_rad)) {
    cone_rad_ = std::max(cone_rad_, message.field_of_view_rad);
  }
  if (std::isfinite(message.max_range_m)) {
    max_range_m_ = std::max(max_range_m_, message.max_range_m);
  }
  const bool is_whole = std::count(heard_.begin(), heard_.end(), false) == 0;
  if (!ended && is_whole) ended = taken();
  return ended;
}

std::optional<SonarRing::Round> SonarRing::finish() {
  if (std::count(heard_.begin(), heard_.end(), true) == 0) return std::nullopt;
  return taken();
}

std::shared_ptr<const RangeSensor> SonarRing::make_sensor(
    const std::vector<Transform3>& base_from_sonar, const MissionOptions& options) const {
  auto ring = std::make_shared<RangeSensor>();
  ring->kind = SensorKind::sonar;
  const bool has_cone = cone_rad_ > 0.0 && cone_rad_ < kPi;
  ring->half_cone_rad = has_cone ? cone_rad_ / 2.0 : radians(options.sonar_cone_deg) / 2.0;
  const double max_m = max_range_m_ > 0.0 ? std::min(max_range_m_, options.sonar_max_range_m)
                                          : options.sonar_max_range_m;
  ring->max_range_m = static_cast<double>(static_cast<float>(max_m));
  for (const Transform3& mount : base_from_sonar) ring->robot_from_beam.push_back(planar(mount));
  return ring;
}

}  // namespace roomatlas::io
