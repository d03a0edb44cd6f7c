// SPDX-License-Identifier: GPL-3.0-or-later
#include "map_store.hpp"

#include <spdlog/spdlog.h>

#include "console.hpp"
#include "former_store.hpp"
#include "new_store.hpp"
#include "roomatlas/core/counted.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/pipeline/assemble_map.hpp"
#include "store_edits.hpp"
#include "store_metadata.hpp"

namespace roomatlas::apps {

std::size_t map_into_store(const Settings& settings, const Path& file, const MapCells& cells,
                           const Path& store_file) {
  const std::string sha256 = sha256_of_file(file);
  const Former former = former_in(store_file, sha256);
  Settings used = settings;
  const NewStore made(store_file);
  try {
    GeoPackageStore store(made.file(), GeoPackageStore::Mode::create);
    if (!former.rooms.empty()) store.put_former_rooms(former.rooms);
    MissionInfo info;  // a map says nothing of the drive behind it
    info.file = file.filename().string();
    Metadata metadata = metadata_of(info, sha256, settings);
    metadata.erase("mission_json");
    store.put_metadata({*metadata.find("mission_file")});
    store.put_metadata(former.edits);
    used.assemble.edits = edits_for(used, store);
    const Assembly assembly =
        assemble_map(store, cells, used, settings.as_toml, console_progress(settings));
    keep_edits(used.assemble.edits, store);
    store.put_metadata(metadata);  // a store with the map's checksum is whole
    store.finish();
    made.put_in_place();
    show(assembly.plan.issues);
    spdlog::info("{}, {}", counted(assembly.plan.rooms.size(), "room"),
                 openings_text(assembly.plan));
    return assembly.plan.rooms.size();
  } catch (...) {
    made.give_up();
    throw;
  }
}

}  // namespace roomatlas::apps
