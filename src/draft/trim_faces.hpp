// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/draft/wall_faces.hpp"

namespace roomatlas {

/// Ends what sonars heard of a face where a face square to it looks away: a sonar hears the edge of
/// a wall beyond its end, for its cone still touches it. Stretches are cut by up to 0.5 m, and only
/// where few echoes came from beyond.
void trim_at_corners(const ReflectionMap& counts, std::vector<WallFace>& faces);

}  // namespace roomatlas
