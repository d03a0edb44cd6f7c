// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/gyro_track.hpp"

#include <algorithm>
#include <iterator>

namespace roomatlas::io {
namespace {

double seconds_between(std::int64_t from_ns, std::int64_t to_ns) {
  return 1e-9 * static_cast<double>(to_ns - from_ns);
}

}  // namespace

void GyroTrack::add(std::int64_t stamp_ns, const Eigen::Vector3d& turn_rad_per_s) {
  if (!turn_rad_per_s.allFinite()) return;
  if (!samples_.empty() && stamp_ns < samples_.back().stamp_ns - kKept_ns) samples_.clear();
  Sample sample{stamp_ns, turn_rad_per_s, Eigen::Vector3d::Zero(), 0};
  if (!samples_.empty()) {
    const Sample& last = samples_.back();
    if (stamp_ns <= last.stamp_ns) return;
    const double passed_s = seconds_between(last.stamp_ns, stamp_ns);
    sample.turned_rad = last.turned_rad + 0.5 * passed_s * (last.rad_per_s + turn_rad_per_s);
    sample.gaps = last.gaps + (stamp_ns - last.stamp_ns > kLongestGap_ns ? 1 : 0);
  }
  samples_.push_back(sample);
  while (samples_.size() > kMost || stamp_ns - samples_.front().stamp_ns > kKept_ns) {
    samples_.pop_front();
  }
}

std::optional<GyroTrack::Turned> GyroTrack::turned_at(std::int64_t stamp_ns) const {
  const auto after = std::lower_bound(
      samples_.begin(), samples_.end(), stamp_ns,
      [](const Sample& kept, std::int64_t stamp) { return kept.stamp_ns < stamp; });
  if (after == samples_.end()) return std::nullopt;
  if (after->stamp_ns == stamp_ns) return Turned{after->turned_rad, after->gaps};
  if (after == samples_.begin()) return std::nullopt;
  const Sample& before = *std::prev(after);
  if (before.gaps != after->gaps) return std::nullopt;
  const double share = seconds_between(before.stamp_ns, stamp_ns) /
                       seconds_between(before.stamp_ns, after->stamp_ns);
  return Turned{before.turned_rad + share * (after->turned_rad - before.turned_rad), before.gaps};
}

std::optional<Eigen::Vector3d> GyroTrack::turn(std::int64_t from_ns, std::int64_t to_ns) const {
  const auto from = turned_at(from_ns);
  const auto to = turned_at(to_ns);
  if (!from || !to || from->gaps != to->gaps) return std::nullopt;
  return Eigen::Vector3d(to->rad - from->rad);
}

std::optional<std::int64_t> GyroTrack::newest_ns() const {
  if (samples_.empty()) return std::nullopt;
  return samples_.back().stamp_ns;
}

}  // namespace roomatlas::io
