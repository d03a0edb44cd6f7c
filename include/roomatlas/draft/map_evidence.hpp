// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/draft/evidence.hpp"
#include "roomatlas/grid/map_cells.hpp"

namespace roomatlas {

struct MapEvidenceOptions {
  double cell_m = 0.05;             ///< finer maps are drafted in cells of at most this
  double min_floor_m2 = 3.0;        ///< pieces of floor: smaller ones are glimpses and noise
  double min_obstacle_share = 0.5;  ///< of a piece's edge; less was seen through a window. The
                                    ///< largest piece stays whatever its edge
  double max_rim_share = 0.1;  ///< of a piece's edge on the picture's; more lies outside of the
                               ///< building, on paper that nobody coloured
};

/// A finished map as if a laser had made it: free cells that many beams crossed, occupied ones that
/// many hit, and pieces of surface where the two meet. It has no path, and lies in the map's own
/// frame (metres from its lower left corner): `moved` takes what is drafted from it to the
/// building.
///
/// Surfaces lie on the edges of cells; their normals come from total least squares over the
/// boundary around, as far as it is straight to a fraction of a cell: at most 1 m to each side.
/// Unknown strips of up to 0.25 m between floor and an obstacle are walls too: many programs draw
/// one side faintly. Floor that is not the building's (see the options) is taken for unseen.
/// @returns without counts and surfaces where nothing is free
/// @throws std::invalid_argument when the cells' size is not positive
[[nodiscard]] BuildingEvidence evidence_of_map(const MapCells& map,
                                               const MapEvidenceOptions& options = {});

/// The pieces of surface alone, along all floor; in the map's frame, not thinned.
[[nodiscard]] std::vector<SurfacePoint> surfaces_of(const MapCells& map);

}  // namespace roomatlas
