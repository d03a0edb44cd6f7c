// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/planar/planar_map.hpp"

#include <span>
#include <vector>

namespace roomatlas::planar {

/// What a region is. Rooms count from 0 in the order of their ids; all else is negative, so that
/// labels are groups for `PlanarMap::trace`.
using Label = int;
constexpr Label kUnknown = -1;  ///< nobody saw it, or it is outside
constexpr Label kWall = -2;     ///< inside an outline that was widened by walls, and no floor
constexpr Label kDoor = -3;     ///< inside a door opening

/// A planar map, and which of its regions lie side by side. Keeps a reference to the map.
class RegionMap {
 public:
  explicit RegionMap(const PlanarMap& map);

  [[nodiscard]] const PlanarMap& map() const { return map_; }
  [[nodiscard]] std::span<const PlanarMap::Border> borders(int region) const {
    const auto r = static_cast<std::size_t>(region);
    return {borders_.data() + first_[r], first_[r + 1] - first_[r]};
  }

 private:
  const PlanarMap& map_;
  std::vector<std::size_t> first_;
  std::vector<PlanarMap::Border> borders_;
};

/// A piece that lost its label to what surrounds it.
struct Absorbed {
  Label from = kUnknown;
  Label to = kUnknown;
  double area_mm2 = 0.0;
};

/// Gives pieces of rooms smaller than `min_area_mm2` to the neighbour with the longest border
/// (unknown where that is a door or a wall), smallest first.
[[nodiscard]] std::vector<Absorbed> absorb_small_rooms(const RegionMap& regions,
                                                       double min_area_mm2,
                                                       std::vector<Label>& labels);

/// Gives unknown pockets inside one room that are smaller than `max_area_mm2` to the room.
void fill_pinholes(const RegionMap& regions, double max_area_mm2, std::vector<Label>& labels);

/// Gives crumbs of wall smaller than `max_area_mm2`, left between a door and uneven floors, to the
/// room with the longest border. Wall that no room or door is next to becomes unknown.
void clear_wall_crumbs(const RegionMap& regions, double max_area_mm2, std::vector<Label>& labels);

/// Makes wall of unknown pockets that are narrower than `max_width_mm` in the mean.
void fill_wall_cavities(const RegionMap& regions, double max_width_mm, std::vector<Label>& labels);

}  // namespace roomatlas::planar
