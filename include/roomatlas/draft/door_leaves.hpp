// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/draft/occupancy.hpp"
#include "roomatlas/plan/door.hpp"

namespace roomatlas {

struct LeafOptions {
  double narrowest_m = 0.55;     ///< of a door that has a leaf
  double widest_m = 1.35;        ///< wider ones have two, or none
  double hinge_m = 0.15;         ///< from a jamb to the hinge, along the wall
  double depth_m = 0.35;         ///< the same across it: half a wall and more
  double shorter_m = 0.2;        ///< a leaf may look so much shorter than its door is wide ...
  double longer_m = 0.12;        ///< ... or longer: jambs are known to a cell or two
  double least_turn_deg = 35.0;  ///< from shut; less is seen as part of the wall ...
  double most_turn_deg = 145.0;  ///< ... and so is more
  double solid_share = 0.8;      ///< of a leaf's length along which something stands
  double open_share = 0.75;      ///< of its two sides on which nothing does; cupboards have insides
};

/// A door leaf that stands open.
struct DoorLeaf {
  Segment2 line;  ///< hinge to free end; building metres
  Segment2 gap;   ///< jamb to jamb, that it shuts
};

/// The leaves at the gaps of walls: about as long as the gap is wide, at one of its jambs, thin,
/// with floor all around the free end. At most one a gap, and none twice.
[[nodiscard]] std::vector<DoorLeaf> find_leaves(const std::vector<Segment2>& gaps,
                                                const Occupancy& occupancy,
                                                const LeafOptions& options);

/// The faces without those that leaves have, which are no walls.
[[nodiscard]] std::vector<WallFace> without_leaves(std::vector<WallFace> faces,
                                                   const std::vector<DoorLeaf>& leaves);

/// Floor where leaves stand: shut, they stand in the wall.
void clear_leaves(const std::vector<DoorLeaf>& leaves, Occupancy& occupancy);

/// Gives doors their leaves.
void hang_leaves(const std::vector<DoorLeaf>& leaves, std::vector<Door>& doors);

}  // namespace roomatlas
