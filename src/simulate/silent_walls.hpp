// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "roomatlas/core/geometry.hpp"

namespace roomatlas {

/// How a stretch of wall answers a laser.
enum class WallSurface { plain, black, glass };

/// Which stretches of a building are black or glass: all that lies in one square of 2 m, so that
/// both faces of a wall mostly are alike. The squares lie where the seed says.
class SilentWalls {
 public:
  /// @param share of the squares that are not plain, half of them black
  SilentWalls(double share, std::uint64_t seed);

  [[nodiscard]] bool exist() const { return share_ > 0.0; }
  [[nodiscard]] WallSurface at(const Point2& point) const;

 private:
  double share_;
  Point2 origin_ = Point2::Zero();
  std::vector<double> draws_;  ///< [0, 1), one a square
};

}  // namespace roomatlas
