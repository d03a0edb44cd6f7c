// SPDX-License-Identifier: GPL-3.0-or-later
#include "segment_index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomatlas {
namespace {

constexpr double kBucketM = 1.0;  // larger holds more edges, smaller makes more buckets

std::int64_t index_of(double metres) {
  return static_cast<std::int64_t>(std::floor(metres / kBucketM));
}

}  // namespace

SegmentIndex::SegmentIndex(const std::vector<Ring>& rings) {
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Segment2 edge{ring[i], ring[(i + 1) % ring.size()]};
      const Point2 low = edge.a.cwiseMin(edge.b);
      const Point2 high = edge.a.cwiseMax(edge.b);
      if (segments_.empty()) min_ = max_ = {index_of(low.x()), index_of(low.y())};
      for (std::int64_t x = index_of(low.x()); x <= index_of(high.x()); ++x) {
        for (std::int64_t y = index_of(low.y()); y <= index_of(high.y()); ++y) {
          buckets_[{x, y}].push_back(segments_.size());
          min_ = {std::min(min_.first, x), std::min(min_.second, y)};
          max_ = {std::max(max_.first, x), std::max(max_.second, y)};
        }
      }
      segments_.push_back(edge);
    }
  }
}

double SegmentIndex::distance(const Point2& point) const {
  double nearest_m = std::numeric_limits<double>::infinity();
  const std::int64_t cx = index_of(point.x());
  const std::int64_t cy = index_of(point.y());
  const std::int64_t last = std::max(
      {cx - min_.first, max_.first - cx, cy - min_.second, max_.second - cy, std::int64_t{0}});
  // Square rings of buckets, outwards; ring r lies at least (r - 1) buckets away.
  for (std::int64_t r = 0; r <= last && static_cast<double>(r - 1) * kBucketM < nearest_m; ++r) {
    for (std::int64_t x = cx - r; x <= cx + r; ++x) {
      const bool on_side = x == cx - r || x == cx + r;
      for (std::int64_t y = cy - r; y <= cy + r; y += on_side || r == 0 ? 1 : 2 * r) {
        const auto found = buckets_.find({x, y});
        if (found == buckets_.end()) continue;
        for (const std::size_t i : found->second) {
          nearest_m = std::min(nearest_m, roomatlas::distance(segments_[i], point));
        }
      }
    }
  }
  return nearest_m;
}

}  // namespace roomatlas
