// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/maps/read_map.hpp"

#include <algorithm>

#include "nav2_map.hpp"
#include "occupancy_world.hpp"

namespace roomatlas {
namespace {

constexpr double kFinest_m = 0.001;
constexpr double kCoarsest_m = 10.0;

bool is_yaml(const Path& file) { return file.extension() == ".yaml" || file.extension() == ".yml"; }

io::OccupancyScale scale_of(const Path& file, double resolution_m) {
  if (!(resolution_m >= kFinest_m && resolution_m <= kCoarsest_m)) {
    throw UsageError(file.string() +
                     ": a picture does not say how large it is: give --resolution METRES (a pixel, "
                     "from 0.001 to 10), or name the YAML file that belongs to it");
  }
  io::OccupancyScale scale;
  scale.resolution_m = resolution_m;
  return scale;
}

MapCells cells_of(const io::Picture& picture, const io::OccupancyScale& scale) {
  const auto& values = picture.values;
  MapCells map{{scale.resolution_m},
               Raster<MapCell>({{0, 0}, {values.width(), values.height()}}),
               scale.world_from_picture};
  for_each_cell(map.cells.domain, [&](const Cell& cell) {
    map.cells[cell] = io::cell_of(values(cell.x, cell.y), picture.white, scale);
  });
  return map;
}

}  // namespace

bool is_map(const Path& file) {
  // Others, a pipe for one, can be read once, and who reads them says what is wrong.
  if (!std::filesystem::is_regular_file(file)) return false;
  if (is_yaml(file)) return true;
  try {
    return io::is_picture_file(file);
  } catch (const InputError&) {
    return false;  // whoever reads it says what is wrong
  }
}

MapCells read_map(const Path& file, double resolution_m) {
  Path picture = file;
  io::OccupancyScale scale;
  if (is_yaml(file)) {
    if (resolution_m > 0.0) {
      throw UsageError(file.string() +
                       ": says itself how large a pixel is: leave --resolution out");
    }
    const io::Nav2Map map = io::read_nav2_map(file);
    picture = map.picture;
    scale = map.scale;
  } else {
    scale = scale_of(file, resolution_m);
  }
  MapCells map = cells_of(io::parse_picture(io::read_unpacked(picture), picture.string()), scale);
  try {
    io::require_floor(map.cells.values, picture.string());
  } catch (const InputError& nothing) {
    throw NotEnoughError(nothing.what());
  }
  return map;
}

}  // namespace roomatlas
