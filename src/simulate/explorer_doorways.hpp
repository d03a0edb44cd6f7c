// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "explorer_map.hpp"
#include "roomatlas/asr/doorway.hpp"

#include <optional>

namespace roomatlas {

/// The doorway at a point of a way, by `find_doorway`, where the explorer has seen enough of it:
/// free floor before and behind, the space before it wider, and wall on beyond both jambs. In a
/// half-seen corner the unknown would pass for width.
/// @param map_from_way a place on the way; theta is the direction of travel
[[nodiscard]] std::optional<Doorway> seen_doorway(const ExplorerMap& map,
                                                  const Pose2& map_from_way);

}  // namespace roomatlas
