// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/edit/edit.hpp"
#include "roomatlas/rooms/mapped_building.hpp"

namespace roomatlas {

/// Applies statements to a building before it is merged, one after the other. Each is applied where
/// its anchor is found, or not at all; closures are none of its business.
/// @returns an issue for each statement that does not fit, in their order
[[nodiscard]] Issues edit_building(const std::vector<Edit>& edits, MappedBuilding& building);

}  // namespace roomatlas
