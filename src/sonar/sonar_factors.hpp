// SPDX-License-Identifier: GPL-3.0-or-later
// The residuals of the batch of poses and walls. Poses are x, y, heading in the map.
#pragma once

#include <array>

#include "roomatlas/core/pose2.hpp"
#include "wall_pairs.hpp"

namespace roomatlas {

/// One residual between two poses, with its derivatives by x, y and heading of each.
struct PairResidual {
  double value = 0.0;
  std::array<double, 3> by_first{};
  std::array<double, 3> by_second{};
};

/// The step between two poses against the measured one, in the frame of the first: along, across
/// (metres), turn (radians, wrapped).
[[nodiscard]] std::array<PairResidual, 3> step_residuals(const Pose2& map_from_first,
                                                         const Pose2& map_from_second,
                                                         const Pose2& first_from_second);

/// How far a point of the second wall lies beyond the first wall's line, metres. The point is
/// `along_m` from the second's middle.
[[nodiscard]] PairResidual across_residual(const Pose2& map_from_first, const SeenWall& first,
                                           const Pose2& map_from_second, const SeenWall& second,
                                           double along_m);

}  // namespace roomatlas
