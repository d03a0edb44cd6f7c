// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/draft/occupancy.hpp"
#include "roomatlas/draft/wall_faces.hpp"

namespace roomatlas {

/// When a face before another is furniture's.
struct FrontOptions {
  double shallowest_m = 0.3;  ///< nearer ones are steps of the wall: pillars, reveals
  double deepest_m = 1.0;     ///< of cupboards; larger takes steps of the building for furniture
  double longest_m = 6.0;     ///< of a row
  double beside_m = 1.0;      ///< from where the wall is lost to where the front begins
  double least_wall_m = 0.6;  ///< of wall that was seen on the line behind ...
  double least_share = 0.25;  ///< ... and of the front's length: less may be a niche
  double open_share = 0.3;    ///< of what is behind a wall; behind furniture there is floor again
};

struct WallOptions {
  FrontOptions fronts;
  double laser_share = 0.12;       ///< of beams that a face's cells must reflect to be there ...
  double sonar_share = 0.06;       ///< ... where sonars heard it
  double min_laser_face_m = 0.25;  ///< what is left of a face after that; shorter ones are none
  double min_sonar_face_m = 0.4;
  double same_line_m = 0.08;        ///< faces this near are on one line of the building
  double min_body_support_m = 0.6;  ///< of the faces of a wall ...
  double thin_m = 0.25;             ///< ... and of one no thicker than this ...
  double min_thin_support_m = 0.3;  ///< ... less: beside doors there is little to see
  double thinnest_m = 0.02;
  double thickest_m = 0.45;        ///< larger takes rooms of cupboards for walls
  double nested_m = 0.05;          ///< a wall that much thicker than another on the same face is a
                                   ///< cupboard's front and the wall behind it
  double door_m = 1.6;             ///< a face goes on across gaps up to this: doors ...
  double hidden_free_share = 0.1;  ///< ... and across any where less than this is free
  double hidden_reach_m = 8.0;     ///< up to where its line is seen again
  double hidden_end_m = 2.5;       ///< it ends at the strongest line this far beyond, if hidden
};

/// A wall of two faces.
struct WallBody {
  std::size_t front = 0;  ///< place of a face; the stretches count along it
  std::size_t back = 0;   ///< of the face that looks away from it
  double thickness_m = 0.0;
  std::vector<Interval> stretches;  ///< where both faces go on
};

/// What a building's faces say once they are compared with the cells and with each other.
struct Walls {
  std::vector<WallFace> faces;   ///< cut to where cells reflect, with their prominence
  std::vector<WallBody> bodies;  ///< thinnest first
};

/// The faces cut to where the counted cells reflect; those of which too little is left are dropped.
[[nodiscard]] std::vector<WallFace> confirmed_faces(std::vector<WallFace> faces,
                                                    const BuildingEvidence& evidence,
                                                    const WallOptions& options);

/// @param faces confirmed
[[nodiscard]] Walls build_walls(std::vector<WallFace> faces, const Occupancy& occupancy,
                                const WallOptions& options);

}  // namespace roomatlas
