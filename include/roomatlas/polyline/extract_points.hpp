// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/polyline/clean_map.hpp"

namespace roomatlas {

using CellChain = std::vector<Cell>;

/// ExtractPoints (paper III.C, Fig. 6): follows the occupied cells from neighbour to nearest
/// neighbour, removing each, and ends a polyline where the next one is farther than gamma.
/// Every occupied cell is in exactly one chain.
/// Change to the paper: where the paper starts in the middle of a wall, the rest of that wall
/// becomes a second polyline; here a chain is then followed from its start the other way as well.
/// @param gamma_cells the largest gap inside one polyline (paper: 4). Larger bridges doorways
[[nodiscard]] std::vector<CellChain> extract_points(const CellMap& map, double gamma_cells);

/// The chains in metres, each point moved to the centre of the raw certainty around it: the
/// front layer that CleanMap keeps lies one cell before the wall, because HIMM raises the eight
/// neighbours of a hit; the band of raised cells is centred on the wall.
/// @param refine false gives the centres of the cells, as the paper does
[[nodiscard]] std::vector<Polyline> chain_points(const std::vector<CellChain>& chains,
                                                 const HimmGrid& grid, double epsilon, bool refine);

/// The refined position of one occupied cell, see `chain_points`.
[[nodiscard]] Point2 refined_point(const Cell& cell, const HimmGrid& grid, double epsilon);

}  // namespace roomatlas
