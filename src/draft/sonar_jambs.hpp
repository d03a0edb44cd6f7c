// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "roomatlas/draft/evidence.hpp"
#include "roomatlas/draft/wall_faces.hpp"

namespace roomatlas {

/// Where a wall ends on both sides of an opening, by what makes the echoes in front of it most
/// likely: a sonar hears the nearest point of the wall inside its cone, which beside an opening is
/// the foot of the perpendicular or, once that lies in the opening, the jamb; what it hears through
/// the opening is farther away. Both jambs are tried in steps of 2 cm.
/// @param middle_m of the opening, along the face
/// @returns nothing where fewer than 20 echoes tell
[[nodiscard]] std::optional<Interval> sonar_jambs(const WallFace& face, double middle_m,
                                                  const BuildingEvidence& evidence);

}  // namespace roomatlas
