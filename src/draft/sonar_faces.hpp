// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/draft/wall_faces.hpp"

namespace roomatlas {

/// The faces that echoes vote for: long ones of every direction first, since what they echo at a
/// slant would vote for steps along another direction; then all others along the building's.
[[nodiscard]] std::vector<WallFace> sonar_faces(const BuildingEvidence& evidence,
                                                const WallFaceOptions& options, int jobs);

}  // namespace roomatlas
