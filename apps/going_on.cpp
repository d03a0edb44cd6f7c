// SPDX-License-Identifier: GPL-3.0-or-later
#include "going_on.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <filesystem>

#include "new_store.hpp"
#include "roomatlas/core/counted.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "store_metadata.hpp"

namespace roomatlas::apps {
namespace {

std::string value_in(const Metadata& metadata, const std::string& key) {
  const auto entry = metadata.find(key);
  return entry == metadata.end() ? std::string() : entry->second;
}

/// Why a run does not go on with a store that is made from and with something else.
std::string difference(const Metadata& origin, const std::string& mission_sha256) {
  if (value_in(origin, "mission_sha256") != mission_sha256) return "of another log";
  const std::string version = value_in(origin, "tool_version");
  if (version != ROOMATLAS_VERSION) return "by version " + version + " of this program";
  return "with other parameters";
}

std::optional<UnfinishedStore> unfinished_at(const Settings& settings,
                                             const std::string& mission_sha256, const Path& file) {
  std::error_code missing;
  if (!std::filesystem::exists(file, missing)) return std::nullopt;
  std::optional<GeoPackageStore::Unfinished> found;
  try {
    found = GeoPackageStore(file, GeoPackageStore::Mode::read).unfinished();
    if (!found) return std::nullopt;
    if (is_mapped_from(found->origin, mission_sha256, settings)) {
      return UnfinishedStore{file, map_checkpoint_of(found->checkpoint)};
    }
  } catch (
      const InputError& error) {  // whoever carries names over tells of one that cannot be read
    if (found) spdlog::warn("{}: {}: mapping from the log's begin", file.string(), error.what());
    return std::nullopt;
  }
  spdlog::warn("{} holds {} of an interrupted run {}: mapping from the log's begin", file.string(),
               counted(found->last_asr, "room"), difference(found->origin, mission_sha256));
  return std::nullopt;
}

std::string with_commas(std::int64_t number) {
  std::string digits = std::to_string(number);
  for (auto at = std::ssize(digits) - 3; at > 0; at -= 3) {
    digits.insert(static_cast<std::size_t>(at), 1, ',');
  }
  return digits;
}

}  // namespace

std::optional<UnfinishedStore> find_unfinished(const Settings& settings,
                                               const std::string& mission_sha256,
                                               const Path& named) {
  const Path store = behind_links(named);
  auto in_place = unfinished_at(settings, mission_sha256, store);
  auto beside = unfinished_at(settings, mission_sha256, place_beside(store));
  if (!in_place) return beside;
  const bool is_farther = beside && beside->checkpoint.events > in_place->checkpoint.events;
  return is_farther ? beside : in_place;
}

GoneOn gone_on_with(const UnfinishedStore& store, const Path& log, const MissionPart& part) {
  return {log.filename().string() + part.suffix(), store.checkpoint.room.asr - 1,
          part.first + store.checkpoint.readings};
}

std::string to_string(const GoneOn& gone_on) {
  return fmt::format("going on after room {} of an interrupted run (reading {} of the log)",
                     with_commas(gone_on.after_room), with_commas(gone_on.reading));
}

}  // namespace roomatlas::apps
