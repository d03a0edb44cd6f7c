// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/maps/read_world.hpp"
#include "nav2_map.hpp"
#include "occupancy_world.hpp"
#include "roomatlas/io/plans/rooms_geojson.hpp"

#include <algorithm>

namespace roomatlas {
namespace {

bool has_extension(const Path& file, std::initializer_list<const char*> extensions) {
  return std::any_of(extensions.begin(), extensions.end(),
                     [&](const char* extension) { return file.extension() == extension; });
}

/// The file's name without folder and endings.
std::string title_of(const Path& file) {
  const Path name = file.extension() == ".gz" ? file.stem() : file.filename();
  return name.stem().string();
}

FloorPlan read_picture(const Path& file, const io::OccupancyScale& scale,
                       const WorldFileOptions& options) {
  const io::Picture picture = io::parse_picture(io::read_unpacked(file), file.string());
  std::optional<io::Picture> labels;
  if (!options.room_labels.empty()) {
    labels =
        io::parse_picture(io::read_unpacked(options.room_labels), options.room_labels.string());
  }
  FloorPlan world = io::world_of_occupancy(picture, scale, labels, file.string());
  for (Issue& issue : world.issues) issue.file = file.filename().string();
  return world;
}

io::OccupancyScale scale_of(const Path& file, const WorldFileOptions& options) {
  if (!(options.resolution_m >= 0.001 && options.resolution_m <= 10.0)) {
    throw UsageError(file.string() +
                     ": a picture does not say how large it is: give its resolution in metres a "
                     "pixel, from 0.001 to 10, or name the YAML file that belongs to it");
  }
  io::OccupancyScale scale;
  scale.resolution_m = options.resolution_m;
  return scale;
}

}  // namespace

FloorPlan read_world(const Path& file, const WorldFileOptions& options) {
  if (options.resolution_m > 0.0 && !io::is_picture_file(file)) {
    throw UsageError(file.string() +
                     ": a resolution is given for pictures, and this is none: leave it away");
  }
  FloorPlan world;
  if (has_extension(file, {".yaml", ".yml"})) {
    const io::Nav2Map map = io::read_nav2_map(file);
    world = read_picture(map.picture, map.scale, options);
  } else if (io::is_picture_file(file)) {
    world = read_picture(file, scale_of(file, options), options);
  } else {
    if (!options.room_labels.empty()) {
      throw UsageError(options.room_labels.string() +
                       ": room labels belong to a picture, and the world " + file.string() +
                       " is not one");
    }
    return read_any_plan(file);
  }
  world.title = title_of(file);
  return world;
}

}  // namespace roomatlas
