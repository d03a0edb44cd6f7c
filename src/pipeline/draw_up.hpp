// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/assembly/assembly.hpp"
#include "roomatlas/pipeline/options.hpp"
#include "roomatlas/rooms/mapped_building.hpp"

namespace roomatlas {

/// The plan of a building whose rooms are known; where walls are made regular, also as measured.
void draw_up(MappedBuilding building, const AssembleOptions& options, Assembly& assembly);

}  // namespace roomatlas
