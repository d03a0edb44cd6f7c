// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/laser_group.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace roomatlas::io {
namespace {

constexpr std::size_t kMostHeld = 256;  // sweeps of one laser

}  // namespace

LaserGroup::LaserGroup(const std::vector<std::size_t>& others, std::int64_t near_ns)
    : topics_(others), near_ns_(near_ns) {
  for (const std::size_t topic : others) others_[topic] = {};
}

void LaserGroup::add(std::size_t topic, Sweep sweep) {
  std::deque<Sweep>& held = others_.at(topic);
  const auto place = std::upper_bound(
      held.begin(), held.end(), sweep.stamp_ns,
      [](std::int64_t stamp_ns, const Sweep& other) { return stamp_ns < other.stamp_ns; });
  held.insert(place, std::move(sweep));
  if (held.size() <= kMostHeld) return;
  held.pop_front();
  ++left_out_;
}

bool LaserGroup::is_there(std::size_t topic, std::int64_t stamp_ns) const {
  const std::deque<Sweep>& held = others_.at(topic);
  return !held.empty() && held.back().stamp_ns >= stamp_ns;
}

const LaserGroup::Sweep* LaserGroup::nearest(std::size_t topic, std::int64_t stamp_ns) const {
  const Sweep* best = nullptr;
  for (const Sweep& sweep : others_.at(topic)) {
    const auto off = [&](const Sweep& s) { return std::abs(s.stamp_ns - stamp_ns); };
    if (off(sweep) <= near_ns_ && (best == nullptr || off(sweep) < off(*best))) best = &sweep;
  }
  return best;
}

void LaserGroup::forget_before(std::size_t topic, std::int64_t stamp_ns, const Sweep* used) {
  std::deque<Sweep>& held = others_.at(topic);
  const std::int64_t used_ns =
      used != nullptr ? used->stamp_ns : std::numeric_limits<std::int64_t>::min();
  while (!held.empty() &&
         (held.front().stamp_ns <= used_ns || held.front().stamp_ns < stamp_ns - near_ns_)) {
    if (held.front().stamp_ns != used_ns) ++left_out_;
    held.pop_front();
  }
}

std::shared_ptr<const RangeSensor> LaserGroup::sensor_of(const Sensors& sensors) {
  auto& known = joined_[sensors];
  if (known) return known;
  auto all = std::make_shared<RangeSensor>();
  for (const auto& sensor : sensors) {
    all->max_range_m = std::max(all->max_range_m, sensor->max_range_m);
    all->robot_from_beam.insert(all->robot_from_beam.end(), sensor->robot_from_beam.begin(),
                                sensor->robot_from_beam.end());
  }
  known = std::move(all);
  return known;
}

RangeReading LaserGroup::joined(const std::vector<std::optional<RangeReading>>& parts) {
  constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
  last_.resize(parts.size());
  Sensors sensors;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i]) last_[i] = parts[i]->sensor;
    if (!parts[i]) ++missing_;
    if (last_[i]) sensors.push_back(last_[i]);
  }
  RangeReading all = *parts.front();
  all.sensor = sensor_of(sensors);
  all.ranges_m.clear();
  all.sweep_s = 0.0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!last_[i]) continue;
    std::vector<float> ranges_m(last_[i]->robot_from_beam.size(), kUnknown);
    if (parts[i]) ranges_m = parts[i]->ranges_m;
    // what the shorter of two did not meet within its range says nothing of the longer one's
    const bool is_shorter = last_[i]->max_range_m < all.sensor->max_range_m;
    for (float& range_m : ranges_m) {
      if (is_shorter && static_cast<double>(range_m) >= last_[i]->max_range_m) range_m = kUnknown;
    }
    all.ranges_m.insert(all.ranges_m.end(), ranges_m.begin(), ranges_m.end());
  }
  return all;
}

}  // namespace roomatlas::io
