// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/transform_track.hpp"

#include <algorithm>
#include <iterator>

namespace roomatlas::io {

bool TransformTrack::is_set_back(std::int64_t stamp_ns, const Transform3& sample) const {
  constexpr std::ptrdiff_t kFewest = 3;  // samples that came before it and are newer
  if (samples_.empty()) return false;
  const std::int64_t late_ns = samples_.back().stamp_ns - stamp_ns;
  if (late_ns > kKept_ns) return true;
  const auto next = std::lower_bound(
      samples_.begin(), samples_.end(), stamp_ns,
      [](const Sample& kept, std::int64_t stamp) { return kept.stamp_ns < stamp; });
  if (late_ns <= kLate_ns || samples_.end() - next < kFewest) return false;
  if (next->stamp_ns == stamp_ns) return !is_same(next->transform, sample);
  return next == samples_.begin() || next->stamp_ns - std::prev(next)->stamp_ns < late_ns;
}

TransformTrack::Added TransformTrack::add(std::int64_t stamp_ns, const Transform3& sample) {
  Added added = Added::in_order;
  if (is_set_back(stamp_ns, sample)) {
    samples_.clear();
    constant_ = true;
    added = Added::clock_set_back;
  }
  constant_ = constant_ && (samples_.empty() || is_same(samples_.back().transform, sample));
  const auto place = std::upper_bound(
      samples_.begin(), samples_.end(), stamp_ns,
      [](std::int64_t stamp, const Sample& kept) { return stamp < kept.stamp_ns; });
  if (place != samples_.begin() && std::prev(place)->stamp_ns == stamp_ns) {
    return Added::again;  // the first one holds: readings may have used it
  }
  if (place != samples_.end()) added = Added::out_of_order;
  samples_.insert(place, {stamp_ns, sample});
  while (samples_.size() > kMost ||
         samples_.back().stamp_ns - samples_.front().stamp_ns > kKept_ns) {
    // the last sample before a silence is kept: what is between is interpolated from it
    if (samples_.size() <= kMost && samples_[1].stamp_ns > samples_.back().stamp_ns - kKept_ns)
      break;
    samples_.pop_front();
  }
  return added;
}

std::optional<TransformAt> TransformTrack::at(std::int64_t stamp_ns) const {
  if (samples_.empty()) return std::nullopt;
  const Sample& first = samples_.front();
  const Sample& last = samples_.back();
  if (stamp_ns <= first.stamp_ns) return TransformAt{first.transform, first.stamp_ns - stamp_ns};
  if (stamp_ns >= last.stamp_ns) return TransformAt{last.transform, stamp_ns - last.stamp_ns};
  const auto after = std::lower_bound(
      samples_.begin(), samples_.end(), stamp_ns,
      [](const Sample& kept, std::int64_t stamp) { return kept.stamp_ns < stamp; });
  if (after->stamp_ns == stamp_ns) return TransformAt{after->transform, 0};
  const Sample& before = *std::prev(after);
  const double fraction = static_cast<double>(stamp_ns - before.stamp_ns) /
                          static_cast<double>(after->stamp_ns - before.stamp_ns);
  return TransformAt{interpolate(before.transform, after->transform, fraction), 0};
}

}  // namespace roomatlas::io
