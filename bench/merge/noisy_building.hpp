// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "roomatlas/merge/merge.hpp"

namespace roomatlas::bench {

/// What a correction hands to `merge`: outlines as sensors draw them, placed with small errors.
struct NoisyBuilding {
  std::vector<PlacedOutline> outlines;
  std::vector<Door> doors;
  std::vector<Polygon> openings;  ///< parallel to `doors`: floor through the wall

  /// The polygons whose union is the free space: outlines and openings.
  [[nodiscard]] std::vector<Polygon> free_space() const;
};

/// Blocks of 21 rooms, in a square of blocks. A block: 16 rooms around a corridor that is a ring;
/// in its court a building with a court of its own, in which a shaft stands; two link rooms to the
/// next blocks, so that four blocks enclose a court too. Holes are nested on both sides: rooms have
/// pillars, and what surrounds them has islands. Outlines have a vertex every 0.6 m with 2 cm of
/// noise, poses are off by 3 cm and 0.5 degrees, so that walls between neighbours vary and some
/// rooms overlap. Every polygon is valid on the 1 mm grid, on which all coordinates lie.
[[nodiscard]] NoisyBuilding noisy_building(std::int64_t rooms, std::uint64_t seed = 1);

}  // namespace roomatlas::bench
