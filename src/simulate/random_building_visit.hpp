// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "random_building_layout.hpp"
#include "random_stream.hpp"

#include <vector>

namespace roomatlas::random_building_layout {

/// What a visit saw of a space, as the recorder would have drawn it.
struct VisitShape {
  std::vector<WallPolyline> walls_asr;
  Polygon outline_asr;
};

/// A doorway that was driven through, and what was measured of it.
struct UsedDoorway {
  const LaidOpening* opening = nullptr;
  Exit exit;
};

/// The part of a space that is seen from a path: rooms as a whole, of corridors what is near.
/// @param path_box world metres
[[nodiscard]] Box2 seen_part(const Space& space, const Box2& path_box);

/// Walls, broken at the doors, and the outline, which reaches into the used doorways up to their
/// measured jambs. Where the seen part ends in the middle of a corridor there is no wall.
/// @param asr_from_world where the robot takes itself to be
[[nodiscard]] VisitShape shape_of_visit(const Space& space, const Box2& seen,
                                        const std::vector<UsedDoorway>& used,
                                        const Pose2& asr_from_world, double vertex_noise_m,
                                        RandomStream& noise);

}  // namespace roomatlas::random_building_layout
