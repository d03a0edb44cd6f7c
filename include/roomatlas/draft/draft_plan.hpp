// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "roomatlas/draft/walls.hpp"
#include "roomatlas/grid/raster.hpp"
#include "roomatlas/plan/door.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

/// Which floor belongs to which room, and where one ends at another.
struct RoomSeeds {
  Raster<std::int32_t> room_of_cell;  ///< in cells of the occupancy; 0: none
  std::vector<Door> openings;         ///< between two rooms
};

struct DraftOptions {
  double extend_long_m = 6.0;     ///< lines of faces of `long_face_m` go on this far beyond ...
  double extend_short_m = 1.5;    ///< ... those of shorter ones this far ...
  double extend_slanted_m = 0.6;  ///< ... and those that follow no direction of the building
  double long_face_m = 2.0;
  double extend_door_m = 0.4;  ///< the line of an opening, beyond its jambs
  double through_door_m =
      0.35;                   ///< across the wall at each jamb: no wall is thicker than twice this
  double solid_cost = 8.0;    ///< a square metre of floor that becomes solid, or another room's
  double hidden_cost = 1.0;   ///< the same of floor that furniture before a wall hides; 0: what
                              ///< furniture hides is unseen like all else
  double unseen_cost = 0.25;  ///< a square metre of room that nobody saw ...
  double deep_unseen_cost = 3.0;        ///< ... and that lies `deep_m` from all floor that was seen
  double sonar_deep_unseen_cost = 0.5;  ///< the same of sonars, which hear little between furniture
  double deep_m = 0.9;
  double other_floor_cost = 0.6;  ///< a square metre of room that is floor of no room
  double wall_body_cost = 20.0;   ///< a square metre of room between the two faces of a wall
  double border_cost = 0.04;      ///< a metre of border along a very prominent line ...
  double faint_cost = 1.0;        ///< ... more for a faint one ...
  double sonar_faint_cost = 3.0;  ///< ... of sonars: sides of furniture are faint walls ...
  double prominence_m = 4.0;      ///< ... falling by e over this much wall
  double no_wall_cost = 0.34;     ///< a metre of border along no wall's line
  double unknown_cost = 0.1;      ///< a metre of border where neither wall nor floor was seen
  double free_cost = 3.0;         ///< a metre of border across floor
  double door_cost = 0.3;         ///< a metre of border in an opening
  double mixed_free_m2 = 0.5;     ///< cells with more floor than this ...
  double mixed_unseen_m2 = 2.0;   ///< ... and more unseen are cut where floor ends
  double min_room_m2 = 2.0;
  double min_hole_m2 = 12.0;  ///< smaller solids inside a room are furniture
};

/// One room as an architect would draw it.
struct DraftedRoom {
  RoomId id = 0;
  Polygon outline;  ///< building metres
};

struct Draft {
  std::vector<DraftedRoom> rooms;    ///< ascending by id; rooms without floor of their own are not
  std::vector<Polygon> wall_bodies;  ///< between the two faces of walls
};

/// Decides where walls run: the lines of all faces cut the plane into cells, and each becomes
/// solid or a room such that the labels agree best with what was seen free, unseen and hit.
[[nodiscard]] Draft draft_plan(const Walls& walls, const Occupancy& occupancy,
                               const RoomSeeds& seeds, const DraftOptions& options);

}  // namespace roomatlas
