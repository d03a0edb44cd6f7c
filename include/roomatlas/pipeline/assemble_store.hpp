// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "roomatlas/assembly/assembly_store.hpp"
#include "roomatlas/core/progress.hpp"
#include "roomatlas/pipeline/options.hpp"

namespace roomatlas {

/// Assembles a store's ASRs, gives the rooms the numbers and names that they had before, and puts
/// all of it back at once. Of a store that was joined from several missions the visits stay where
/// joining put them: the plan alone is drawn anew.
/// @param configuration of `options`, as it is to stand in the store (TOML)
/// @returns what was put
[[nodiscard]] Assembly assemble_store(AssemblyStore& store, const Options& options,
                                      const std::string& configuration,
                                      const Progress& progress = {});

}  // namespace roomatlas
