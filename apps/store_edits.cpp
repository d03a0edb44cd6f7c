// SPDX-License-Identifier: GPL-3.0-or-later
#include "store_edits.hpp"

#include <spdlog/spdlog.h>

#include "roomatlas/io/plans/edits_file.hpp"

namespace roomatlas::apps {

std::vector<Edit> stored_edits(const GeoPackageStore& store) {
  const Metadata metadata = store.metadata();
  const auto kept = metadata.find(kEditsKey);
  if (kept == metadata.end()) return {};
  return edits_of(kept->second, std::string("metadata ") + kEditsKey);
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

Metadata edits_to_carry_over(const Path& store_file, const std::string& mission_sha256) {
  if (!std::filesystem::exists(store_file)) return {};
  try {
    const Metadata metadata = GeoPackageStore(store_file, GeoPackageStore::Mode::read).metadata();
    const auto kept = metadata.find(kEditsKey);
    if (kept == metadata.end()) return {};
    const auto sha256 = metadata.find("mission_sha256");
    if (sha256 == metadata.end() || sha256->second == mission_sha256) return {*kept};
    spdlog::warn("{} was made from another log: the corrections by hand that it kept are lost",
                 store_file.string());
  } catch (const InputError&) {
    // whoever carries the rooms over says so
  }
  return {};
}

}  // namespace roomatlas::apps
