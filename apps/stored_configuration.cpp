// SPDX-License-Identifier: GPL-3.0-or-later
#include "stored_configuration.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <functional>
#include <vector>

#include "roomatlas/core/issue.hpp"

namespace roomatlas::apps {
namespace {

using TakesStage = std::function<bool(Stage)>;

/// A configuration's parameters of mapping, and all others as nothing was said.
std::string mapping_of(const std::string& toml) {
  return with_configuration(default_settings(), toml,
                            [](const std::string&, Stage stage) { return is_of_mapping(stage); })
      .settings.as_toml;
}

Settings with_stages(const Settings& settings, const TakesStage& takes, const std::string& toml,
                     const std::string& store) {
  const auto is_taken = [&](const std::string& name, Stage stage) {
    return takes(stage) && !settings.given.contains(name);
  };
  try {
    const FromConfiguration stored = with_configuration(settings, toml, is_taken);
    if (!stored.unknown.empty()) {
      spdlog::warn("{}: it was made with parameters that this version does not know: {}", store,
                   fmt::join(stored.unknown, ", "));
    }
    return stored.settings;
  } catch (const UsageError& error) {
    spdlog::warn(
        "{}: this version cannot read the parameters that it was made with, those of this run "
        "hold: {}",
        store, error.what());
    return settings;
  }
}

/// The first of these keys that the store has.
std::string first_of(const Metadata& metadata, const std::vector<const char*>& keys) {
  for (const char* key : keys) {
    const auto entry = metadata.find(key);
    if (entry != metadata.end()) return entry->second;
  }
  return "";
}

}  // namespace

bool map_alike(const std::string& one, const std::string& other) {
  if (one == other) return true;
  try {
    return mapping_of(one) == mapping_of(other);
  } catch (const UsageError&) {
    return false;  // made by a version with other bounds
  }
}

Settings as_mapped(const Settings& settings, const Metadata& metadata,
                   const std::filesystem::path& store) {
  const std::string toml = first_of(metadata, {"rooms_configuration", "configuration"});
  return with_stages(
      settings, [](Stage stage) { return stage == Stage::rooms; }, toml, store.string());
}

Settings as_corrected(const Settings& settings, const Metadata& metadata,
                      const std::filesystem::path& store) {
  const std::string toml = first_of(metadata, {"assembly_configuration", "configuration"});
  return with_stages(
      settings, [](Stage stage) { return stage == Stage::correction; }, toml, store.string());
}

Settings as_recorded(const Settings& settings, const Metadata& metadata,
                     const std::filesystem::path& store) {
  const std::string toml = first_of(metadata, {"configuration"});
  return with_stages(
      settings, [](Stage stage) { return stage != Stage::simulation; }, toml, store.string());
}

}  // namespace roomatlas::apps
