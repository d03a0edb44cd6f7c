// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "roomatlas/rooms/partition_rooms.hpp"

namespace roomatlas::bench {

/// A finished map whose rooms are known.
struct LabelledMap {
  std::string name;
  bool furnished = false;
  PartitionEvidence evidence;
  Raster<std::int32_t> true_room;  ///< 0: no room; the evidence's box
};

/// The maps of a folder, one folder each: NAME/NAME.png, NAME/NAME_furnitures.png and
/// NAME/NAME_gt_labels.pgm.gz of one size, 0.05 m a pixel, sorted by name.
[[nodiscard]] std::vector<std::string> labelled_map_names(const std::filesystem::path& folder);
[[nodiscard]] LabelledMap read_labelled_map(const std::filesystem::path& folder,
                                            const std::string& name, bool furnished);

/// The map drawn again turned by an angle: each cell takes the value at its centre.
[[nodiscard]] LabelledMap turned(const LabelledMap& map, double angle_rad);

/// The map with cells twice as large: an obstacle where any of the four was, and free where two
/// were and no obstacle.
[[nodiscard]] LabelledMap halved(const LabelledMap& map);

}  // namespace roomatlas::bench
