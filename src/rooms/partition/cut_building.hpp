// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "piece_openings.hpp"

namespace roomatlas {

/// A building's floor in pieces, before any of them are joined.
struct CutBuilding {
  OpenFloor floor;
  FloorPieces pieces;
  std::vector<PieceOpening> openings;
};

/// The first half of `partition_rooms`: all that does not depend on what was learned.
[[nodiscard]] CutBuilding cut_building(const PartitionEvidence& evidence,
                                       const PartitionOptions& options);

}  // namespace roomatlas
