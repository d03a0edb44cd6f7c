// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands.hpp"
#include "roomatlas/grid/map_cells.hpp"

namespace roomatlas::apps {

/// Drafts a finished map into a store without a mission, in the place of what is there; rooms of a
/// store of the same file keep their numbers and names.
/// @param file of the map, for its name and to know it again
/// @returns how many rooms the plan has
std::size_t map_into_store(const Settings& settings, const Path& file, const MapCells& cells,
                           const Path& store);

}  // namespace roomatlas::apps
