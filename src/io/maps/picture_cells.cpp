// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "occupancy_world.hpp"

namespace roomatlas::io {

MapCell cell_of(int value, int white, const OccupancyScale& scale) {
  if (value == Picture::kTransparent) return MapCell::unknown;
  const double brightness = static_cast<double>(value) / white;
  if (scale.mode == MapMode::raw) {  // counts, which are not turned round
    const double occupancy = std::round(255.0 * brightness) / 100.0;
    if (occupancy > 1.0) return MapCell::unknown;
    if (occupancy >= scale.occupied_threshold) return MapCell::occupied;
    return occupancy <= scale.free_threshold ? MapCell::free : MapCell::unknown;
  }
  const double occupancy = scale.negate ? brightness : 1.0 - brightness;
  if (scale.mode == MapMode::scale) {
    const double middle = (scale.occupied_threshold + scale.free_threshold) / 2.0;
    return occupancy > middle ? MapCell::occupied : MapCell::free;
  }
  if (occupancy > scale.occupied_threshold) return MapCell::occupied;
  return occupancy < scale.free_threshold ? MapCell::free : MapCell::unknown;
}

void require_floor(const std::vector<MapCell>& cells, const std::string& name) {
  if (std::find(cells.begin(), cells.end(), MapCell::free) != cells.end()) return;
  throw InputError(name +
                   ": no pixel is free: expected white floor and black walls; where it is "
                   "the other way round, describe it in a YAML file with \"negate: 1\"");
}

}  // namespace roomatlas::io
