// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "roomatlas/core/pose2.hpp"

namespace roomatlas::test {

/// Adds a drive from point to point, a pose each 0.1 m.
inline void add_drive(const std::vector<Point2>& points, std::vector<Pose2>& path) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point2 way = points[i] - points[i - 1];
    const int steps = static_cast<int>(std::ceil(way.norm() / 0.1));
    for (int k = 0; k <= steps; ++k) {
      const Point2 at = points[i - 1] + way * k / steps;
      path.push_back({at.x(), at.y(), std::atan2(way.y(), way.x())});
    }
  }
}

}  // namespace roomatlas::test
