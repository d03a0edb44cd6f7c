// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "arrangement.hpp"
#include "label_cells.hpp"
#include "roomatlas/draft/draft_plan.hpp"

namespace roomatlas {

/// What was seen in one cell of an arrangement; square metres.
struct CellEvidence {
  std::map<RoomId, double> floor_m2;   ///< by room
  std::map<RoomId, double> hidden_m2;  ///< floor of a room that furniture hides
  double other_floor_m2 = 0.0;         ///< of no room
  double unseen_m2 = 0.0;              ///< near floor that was seen
  double deep_unseen_m2 = 0.0;         ///< far from it
  bool is_wall_body = false;           ///< between the two faces of a wall
};

[[nodiscard]] std::vector<CellEvidence> cell_evidence(const Arrangement& arrangement,
                                                      const Walls& walls,
                                                      const Occupancy& occupancy,
                                                      const RoomSeeds& seeds,
                                                      const DraftOptions& options);

/// What each cell may become, at which cost. Label 0 is solid, label k the k-th of `rooms`.
[[nodiscard]] std::vector<LabelCosts> costs_of(const Arrangement& arrangement,
                                               const std::vector<CellEvidence>& evidence,
                                               const std::vector<RoomId>& rooms,
                                               const DraftOptions& options);

/// What each border costs where its cells become different things.
[[nodiscard]] std::vector<LabelBorder> borders_of(const Arrangement& arrangement,
                                                  const Occupancy& occupancy,
                                                  const RoomSeeds& seeds,
                                                  const DraftOptions& options);

}  // namespace roomatlas
