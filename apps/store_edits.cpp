// SPDX-License-Identifier: GPL-3.0-or-later
#include "store_edits.hpp"

#include "roomatlas/io/plans/edits_file.hpp"
#include "store_metadata.hpp"

namespace roomatlas::apps {

std::vector<Edit> stored_edits(const GeoPackageStore& store) {
  const Metadata metadata = store.metadata();
  const auto kept = metadata.find(kEditsKey);
  if (kept == metadata.end()) return {};
  return edits_of(kept->second, store.file().string() + ": metadata " + kEditsKey);
}

std::vector<Edit> edits_for(const Settings& settings, const GeoPackageStore& store) {
  if (settings.edits_file.empty()) return stored_edits(store);
  return with_places(read_edits(settings.edits_file), store.former_rooms());
}

void keep_edits(const std::vector<Edit>& edits, GeoPackageStore& store) {
  const Metadata metadata = store.metadata();
  const std::string text = edits_json(edits);
  const auto kept = metadata.find(kEditsKey);
  if (kept == metadata.end() ? edits.empty() : kept->second == text) return;
  store.put_metadata({{kEditsKey, text}});
}

}  // namespace roomatlas::apps
