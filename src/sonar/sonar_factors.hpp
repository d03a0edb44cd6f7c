// SPDX-License-Identifier: GPL-3.0-or-later
// The residuals of the batch of poses and walls. Poses are x, y, heading in the map.
#pragma once

#include <array>
#include <optional>

#include "return_matches.hpp"
#include "roomatlas/core/pose2.hpp"
#include "roomatlas/sonar/wall_segments.hpp"
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

/// A wall where its node stands: what its pairs ask of it, worked out once for all of them.
struct PlacedWall {
  double normal_rad = 0.0;  ///< not wrapped
  Point2 normal;
  Point2 node;          ///< position
  Point2 to_middle;     ///< from the node to the wall's middle
  double turned = 0.0;  ///< how the middle moves along the normal as the node turns
};
/// @param transform the same as `map_from_node`
[[nodiscard]] PlacedWall placed(const SeenWall& wall, const Pose2& map_from_node,
                                const PointTransform& transform);

/// A point of a wall, in its node's frame. @param along_m from the wall's middle
[[nodiscard]] Point2 point_on(const SeenWall& wall, double along_m);

/// How far a point of a second wall lies beyond the first wall's line, metres.
/// @param second position of the second wall's node
/// @param point in the map
[[nodiscard]] PairResidual across_residual(const PlacedWall& first, const Point2& second,
                                           const Point2& point);

/// The same for poses as they come. The point is `along_m` from the second's middle.
[[nodiscard]] PairResidual across_residual(const Pose2& map_from_first, const SeenWall& first,
                                           const Pose2& map_from_second, const SeenWall& second,
                                           double along_m);

/// How the range at which a sonar hears a wall grows as the sonar turns left, metres per radian:
/// 0 where the wall's perpendicular lies in the cone, else the wall is heard on the cone's edge.
[[nodiscard]] double range_by_heading(const ConeReturn& from, double half_cone_rad,
                                      const ConeLine& line);

/// How much too far off a wall stands for a return to have come from it, by the model of a cone
/// (`range_to_line`), metres: the range expected less the one heard. Nothing where it cannot have.
/// @param map_from_first node of the return
/// @param map_from_second node of the wall
[[nodiscard]] std::optional<PairResidual> range_residual(const Pose2& map_from_first,
                                                         const SeenReturn& seen,
                                                         const Pose2& map_from_second,
                                                         const SeenWall& wall);

}  // namespace roomatlas
