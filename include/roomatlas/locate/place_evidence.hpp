// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/locate/query_rays.hpp"
#include "roomatlas/locate/seen_building.hpp"

namespace roomatlas {

/// What a visit that is looked for saw, in its ASR's frame: all that a place is judged by.
struct AskedVisit {
  AsrId id = 0;
  Pose2 mission_from_asr;
  FloorSketch sketch;
  std::vector<QueryRay> rays;
};

/// What a building says to a wall, a piece of floor or a ray of a query.
enum class Told : char { nothing, agrees, contradicts };

/// What all of a query was told at one place, visit by visit in the order of what they saw.
struct PlaceEvidence {
  std::vector<Told> walls;
  std::vector<Told> floor;
  std::vector<Told> rays;
};

struct PlaceEvidenceOptions {
  double agree_m = 0.15;   ///< a wall this near to one of the building agrees
  double ray_off_m = 0.3;  ///< a ray that misses by more contradicts; half of it agrees
  double beside_rad =
      0.01;           ///< a laser's neighbours, which see past an edge that it hits or misses
  int cone_rays = 7;  ///< across a sonar's cone
  double facing_cosine = 0.94;  ///< a wall that looks into a cone within 20 degrees gives an echo
};

/// Adds what a building says to a visit at a place.
void add_evidence(const AskedVisit& visit, const SeenBuilding& building,
                  const Pose2& building_from_asr, const PlaceEvidenceOptions& options,
                  PlaceEvidence& evidence);

}  // namespace roomatlas
