// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace roomatlas {

/// The edges of rings in square buckets, to find the nearest.
class SegmentIndex {
 public:
  explicit SegmentIndex(const std::vector<Ring>& rings);

  [[nodiscard]] bool empty() const { return segments_.empty(); }
  /// Distance to the nearest edge, exactly; infinity without edges.
  [[nodiscard]] double distance(const Point2& point) const;

 private:
  using Bucket = std::pair<std::int64_t, std::int64_t>;

  std::vector<Segment2> segments_;
  std::map<Bucket, std::vector<std::size_t>> buckets_;
  Bucket min_{0, 0};  ///< of the buckets with edges
  Bucket max_{0, 0};  ///< likewise
};

}  // namespace roomatlas
