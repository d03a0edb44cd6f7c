// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut_building.hpp"

#include "seen_only.hpp"

namespace roomatlas {

CutBuilding cut_building(const PartitionEvidence& evidence, const PartitionOptions& options) {
  CutBuilding cut;
  cut.floor = open_floor(evidence, options);
  const std::vector<WallChord> chords =
      find_wall_chords(cut.floor, find_floor_sides(cut.floor), evidence.wall_gaps);
  const ChordCells cuts(cut.floor, chords);
  cut.pieces = cut_floor(cut.floor, cuts);
  cut.openings = find_piece_openings(cut.floor, cut.pieces, chords, cuts);
  count_crossings(evidence.building_from_robot, cut.floor.frame, cut.pieces, cut.openings);
  drop_seen_through_walls(evidence.building_from_robot, cut);
  return cut;
}

}  // namespace roomatlas
