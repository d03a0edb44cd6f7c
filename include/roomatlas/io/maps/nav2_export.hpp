// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

struct Nav2Options {
  double cell_m = 0.05;         ///< larger closes narrow doors
  double margin_m = 0.5;        ///< unknown space around the plan
  int cells_at_once = 1 << 24;  ///< in memory: whole rows, one at least; the files are the same
};

/// Writes a plan as maps for nav2's map server, metres in the building's frame: `map.pgm` and
/// `map.yaml` (free 254, walls and furniture 0, unknown 205), `keepout_mask.pgm` and
/// `keepout_mask.yaml` (all that is not free is kept out of), and `rooms.yaml`. A cell is what its
/// centre lies in; walls also have the cells that their edges run through, so that thin ones stay
/// closed, and door openings are free throughout. An empty plan gives a map of one unknown cell.
/// Throws InputError when a file cannot be written, or the map would have more than 2^28 cells.
/// @returns the files' names
std::vector<std::string> write_nav2_map(const std::filesystem::path& folder, const FloorPlan& plan,
                                        const Nav2Options& options = {});

/// False where the map would have more than 2^28 cells.
[[nodiscard]] bool fits_nav2_map(const FloorPlan& plan, const Nav2Options& options = {});

}  // namespace roomatlas
