// SPDX-License-Identifier: GPL-3.0-or-later
#include "store_edits.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <set>

#include "roomatlas/core/counted.hpp"
#include "roomatlas/io/plans/edits_file.hpp"
#include "store_metadata.hpp"

namespace roomatlas::apps {

std::vector<Edit> stored_edits(const GeoPackageStore& store) {
  const Metadata metadata = store.metadata();
  const auto kept = metadata.find(kEditsKey);
  if (kept == metadata.end()) return {};
  return edits_of(kept->second, store.file().string() + ": metadata " + kEditsKey);
}

std::string as_told(Edit edit) {
  for (RoomAnchor& room : edit.rooms) {
    if (room.id) room = {room.id, std::nullopt, {}};
  }
  return edits_json({edit});
}

namespace {

/// `--edits` says all that holds from now on.
void tell_taken_back(const Settings& settings, const GeoPackageStore& store,
                     const std::vector<Edit>& now) try {
  std::set<std::string> said;
  for (const Edit& edit : now) said.insert(as_told(edit));
  const std::vector<Edit> kept = stored_edits(store);
  const auto gone = std::count_if(kept.begin(), kept.end(),
                                  [&](const Edit& edit) { return !said.contains(as_told(edit)); });
  if (gone == 0) return;
  spdlog::warn("{}: {} that the store kept {} not in it and {} taken back", settings.edits_file,
               counted(gone, "correction"), gone == 1 ? "is" : "are", gone == 1 ? "is" : "are");
} catch (const InputError& error) {
  spdlog::warn("{}; those of {} hold in their place", error.what(), settings.edits_file);
}

}  // namespace

std::vector<Edit> edits_for(const Settings& settings, const GeoPackageStore& store) {
  if (settings.edits_file.empty()) return stored_edits(store);
  std::vector<Edit> edits = with_places(read_edits(settings.edits_file), store.former_rooms());
  tell_taken_back(settings, store, edits);
  return edits;
}

void keep_edits(const std::vector<Edit>& edits, GeoPackageStore& store) {
  const Metadata metadata = store.metadata();
  const std::string text = edits_json(edits);
  const auto kept = metadata.find(kEditsKey);
  if (kept == metadata.end() ? edits.empty() : kept->second == text) return;
  store.put_metadata({{kEditsKey, text}});
}

}  // namespace roomatlas::apps
