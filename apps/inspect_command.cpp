// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "commands.hpp"
#include "output_places.hpp"
#include "plugin_formats.hpp"
#include "roomatlas/asr/map_room.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "stored_configuration.hpp"

namespace roomatlas::apps {

void inspect(const Settings& settings, const Path& store_file, AsrId id, const Path& out) {
  const GeoPackageStore store(store_file, GeoPackageStore::Mode::read);
  const Asr asr = store.get(id, AsrDetail::readings);
  if (asr.readings.empty()) {
    throw NotEnoughError(
        fmt::format("{}: ASR {} was stored without its readings; map the log again "
                    "without --no-keep-readings",
                    store_file.string(), id));
  }
  const Metadata metadata = store.metadata();
  const RoomMap map = map_room(asr.path, asr.readings, asr.exits, store.mission().footprint,
                               as_mapped(settings, metadata, store_file).map.record.map);
  Polyline path;
  for (const PathSample& sample : asr.path) path.push_back(sample.asr_from_robot.position());
  const std::string svg = draw_room_steps(map, path, fmt::format("ASR {}, step by step", id));
  make_folder(out);
  const std::string name = fmt::format("asr_{}", id);
  write_file(out / (name + ".svg"), svg);
  write_picture(out / (name + ".png"), svg, settings.png_dpi);

  const AsrCounters& counters = map.counters;
  constexpr const char* kText =
      "ASR {}: grid of {} bytes, {} cells occupied, {} after cleaning, {} points, {} vertices, {} "
      "bytes\n";
  constexpr const char* kJson =
      R"({{"asr": {}, "grid_bytes": {}, "occupied_cells": {}, "cleaned_cells": {}, "points": {}, )"
      R"("vertices": {}, "geometry_bytes": {}}})"
      "\n";
  fmt::print(fmt::runtime(settings.json ? kJson : kText), id, counters.grid_bytes,
             counters.occupied_cells, counters.cleaned_cells, counters.extracted_points,
             counters.vertices, counters.geometry_bytes);
}

}  // namespace roomatlas::apps
