// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "occupancy_world.hpp"

#include <filesystem>

namespace roomatlas::io {

/// What the YAML file of a nav2 (or ROS 1 map_server) map says.
struct Nav2Map {
  std::filesystem::path picture;  ///< beside the YAML file where it is relative
  OccupancyScale scale;
};

/// Reads `image`, `resolution` and `origin`, which must be there, and `negate`,
/// `occupied_thresh`, `free_thresh` and `mode`; other keys are passed over. Where the picture is
/// missing and one with `.gz` behind its name is there, that is taken.
/// Throws InputError naming file, line and key.
[[nodiscard]] Nav2Map read_nav2_map(const std::filesystem::path& file);

}  // namespace roomatlas::io
