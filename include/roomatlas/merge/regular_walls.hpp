// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/merge/merge.hpp"

#include <vector>

namespace roomatlas {

struct RegularWallOptions {
  double max_distance_m = 0.12;  ///< of a regular wall from its evidence; larger straightens more
  double roughness = 0.75;  ///< share of that distance up to which corners are a wall's roughness
  double max_turn_deg = 10.0;       ///< of a wall towards a direction of the building
  double min_wall_m = 0.4;          ///< shorter edges say nothing about directions
  double align_gap_m = 4.0;         ///< walls this far apart along their line may still be one line
  double max_door_turn_deg = 30.0;  ///< of a door into its wall: its jambs lie on two sides of it
  double blind_corner_m = 0.0;      ///< longest edge that cuts off a corner which sonars did not
                                    ///< hear; the two walls then meet. 0: corners stay as seen
  double min_direction_share = 0.12;  ///< of the wall length, for a second direction (a wing)
};

/// The directions that most walls of a building follow, each modulo 90 degrees, in [0, pi/2): by
/// length of edges, the strongest first. A further one needs `min_direction_share` of the length
/// and lies more than twice `max_turn_deg` from the others. Empty without edges of `min_wall_m`.
[[nodiscard]] std::vector<double> building_directions(const std::vector<PlacedOutline>& outlines,
                                                      const RegularWallOptions& options);

/// What became of the outlines.
struct RegularOutlines {
  std::vector<PlacedOutline> outlines;  ///< parallel to the input
  std::vector<Door> doors;              ///< parallel to the input
  std::vector<double> directions_rad;   ///< of the building
  double wall_m = 0.0;                  ///< length of all edges
  double regular_m = 0.0;               ///< length of those that follow a direction
  int kept = 0;                         ///< outlines left as they were, since they would cross
};

/// The outlines with walls along the building's directions, on common lines where they nearly are,
/// and corners where these lines meet. Each end of an edge that follows a direction is within
/// `max_distance_m` of the edge's new line; edges that would have to move farther, slanted and
/// curved walls among them, stay. A ring that would cross itself stays as it was.
/// A door beside a wall that follows a direction, at most `max_door_turn_deg` off, is turned about
/// its middle into that direction, and outlines follow where one of their vertices is a jamb.
[[nodiscard]] RegularOutlines with_regular_walls(std::vector<PlacedOutline> outlines,
                                                 const std::vector<Door>& doors,
                                                 const RegularWallOptions& options);

}  // namespace roomatlas
