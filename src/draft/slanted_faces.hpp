// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/draft/wall_faces.hpp"

namespace roomatlas {

/// Straight pieces of walls in any direction, grown from the surfaces that are seen best: a
/// slanted wall becomes one, a curved one a chain of chords that keep within 4 cm of it.
[[nodiscard]] std::vector<WallFace> slanted_faces(const std::vector<SurfacePoint>& surfaces,
                                                  double min_support_m);

}  // namespace roomatlas
