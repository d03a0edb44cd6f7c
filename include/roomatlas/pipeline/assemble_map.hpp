// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "roomatlas/assembly/assembly_store.hpp"
#include "roomatlas/core/progress.hpp"
#include "roomatlas/draft/map_evidence.hpp"
#include "roomatlas/pipeline/options.hpp"

namespace roomatlas {

/// A finished map of whatever program becomes rooms, doors and a floor plan, in the map's own frame
/// with its origin and turn. There is no mission: graph, correction and paths stay empty.
/// @throws Interrupted when `progress` says so
[[nodiscard]] Assembly assemble_map(const MapCells& map, const Options& options,
                                    const Progress& progress = {});

/// The same into a store without ASRs; rooms get the numbers and names that they had before.
/// @param configuration of `options`, as it is to stand in the store (TOML)
/// @returns what was put
[[nodiscard]] Assembly assemble_map(AssemblyStore& store, const MapCells& map,
                                    const Options& options, const std::string& configuration,
                                    const Progress& progress = {});

}  // namespace roomatlas
