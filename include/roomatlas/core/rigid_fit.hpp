// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/pose2.hpp"

#include <vector>

namespace roomatlas {

/// Two points that a motion should bring together, and how much they count (more than 0).
struct PointPair {
  Point2 from = Point2::Zero();
  Point2 to = Point2::Zero();
  double weight = 1.0;  ///< over those of the other pairs
};

/// The rigid motion `to_from_from` with the least weighted sum of squared distances (Umeyama 1991,
/// in the plane and without scale). One pair gives a shift alone, none the identity.
[[nodiscard]] Pose2 rigid_fit(const std::vector<PointPair>& pairs);

}  // namespace roomatlas
