// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/draft/wall_faces.hpp"
#include "roomatlas/polyline/region.hpp"

namespace roomatlas {

struct OccupancyOptions {
  int min_hits = 2;             ///< fewer are noise
  double occupied_share = 0.2;  ///< reflected share from which a cell is an obstacle; higher loses
                                ///< glass and walls met at flat angles
  int min_seen = 2;             ///< beams; a cell seen less often is not known to be free
  double path_clear_m = 0.15;   ///< around the path all is free: the robot was there
  double stop_behind_m = 0.08;  ///< a sonar's beam ends this far behind the face of a wall
};

/// What a building's cells are; the masks share one domain.
struct Occupancy {
  CellFrame frame;
  CellMask seen{CellBox{}};      ///< a beam reached or crossed it
  CellMask free{CellBox{}};      ///< seen, and no obstacle; under the robot always
  CellMask obstacle{CellBox{}};  ///< walls, furniture, people who stood still
};

/// Decides cell by cell. What sonars heard is counted again with beams that end at the faces that
/// they voted for: a cone's edges reach behind walls; and these faces are the obstacles.
[[nodiscard]] Occupancy occupancy_of(const BuildingEvidence& evidence,
                                     const std::vector<WallFace>& faces,
                                     const OccupancyOptions& options);

}  // namespace roomatlas
