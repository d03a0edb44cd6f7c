// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "roomatlas/core/geometry.hpp"

namespace roomatlas {

/// Segments by the cells of a grid, for questions about what is near. Finite segments alone.
class NearbySegments {
 public:
  void add(const Segment2& segment);
  void add_line(const Polyline& line);
  void add_ring(const Ring& ring);

  /// Whether a segment comes as near to the point as that. @param reach_m up to one cell
  [[nodiscard]] bool is_near(const Point2& point, double reach_m) const;
  /// Whether a segment crosses this one. @param probe not longer than one cell
  [[nodiscard]] bool crosses(const Segment2& probe) const;

 private:
  static constexpr double kCell_m = 1.0;  ///< also the longest reach; larger asks more segments
  using Key = std::int64_t;

  template <typename Test>
  [[nodiscard]] bool any_around(const Point2& point, Test test) const;

  std::unordered_map<Key, std::vector<Segment2>> cells_;
};

}  // namespace roomatlas
