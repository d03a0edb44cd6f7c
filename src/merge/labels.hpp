// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planar_map.hpp"

#include <vector>

namespace roomatlas::planar {

/// What a region is. Rooms count from 0 in the order of their ids; all else is negative, so that
/// labels are groups for `PlanarMap::trace`.
using Label = int;
constexpr Label kUnknown = -1;
constexpr Label kWall = -2;
constexpr Label kDoor = -3;

/// Regions of one label that hang together by more than a vertex.
struct Component {
  Label label = kUnknown;
  bool is_bounded = true;
  double area_mm2 = 0.0;
  double perimeter_mm = 0.0;
  std::vector<int> regions;
  std::vector<PlanarMap::Border> borders;  ///< here `region` is the neighbouring component
};

[[nodiscard]] std::vector<Component> components_of(const PlanarMap& map,
                                                   const std::vector<Label>& labels);

/// The index of the neighbour with the longest common border; -1 without neighbours.
[[nodiscard]] int main_neighbor(const Component& component);

/// A piece that lost its label to what surrounds it.
struct Absorbed {
  Label from = kUnknown;
  Label to = kUnknown;
  double area_mm2 = 0.0;
};

/// Gives pieces of rooms smaller than `min_area_mm2` to the neighbour with the longest border
/// (unknown where that is a door or a wall), smallest first.
[[nodiscard]] std::vector<Absorbed> absorb_small_rooms(const PlanarMap& map, double min_area_mm2,
                                                       std::vector<Label>& labels);

/// Gives unknown pockets inside one room that are smaller than `max_area_mm2` to the room.
void fill_pinholes(const PlanarMap& map, double max_area_mm2, std::vector<Label>& labels);

/// Gives crumbs of wall smaller than `max_area_mm2`, left between a door and uneven floors, to the
/// room with the longest border.
void clear_wall_crumbs(const PlanarMap& map, double max_area_mm2, std::vector<Label>& labels);

/// Makes wall of unknown pockets that are narrower than `max_width_mm` in the mean.
void fill_wall_cavities(const PlanarMap& map, double max_width_mm, std::vector<Label>& labels);

}  // namespace roomatlas::planar
