// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "commands.hpp"
#include "join_stores.hpp"
#include "roomatlas/evaluate/evaluation.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "settings.hpp"

namespace roomatlas::apps {

/// What was made of a building, besides its store.
struct MadeOf {
  const Evaluation& evaluation;
  bool truth_was_given = false;  ///< on the command line: what it says is wanted in full
  std::filesystem::path folder;
  std::vector<std::string> files;  ///< names in the folder
  std::vector<GoneOn> gone_on;     ///< missions in which another run had been stopped
};

/// The end of `build`: rooms with areas and kinds, doors, accuracy, whether it can be trusted and
/// which file to open first; as text for people, or as one JSON object. On stdout.
void report_building(const Settings& settings, const GeoPackageStore& store, const MadeOf& made);

/// What an assembled store holds, as one JSON object on stdout: that of `build` without files.
void tell_assembled(const Settings& settings, const std::filesystem::path& store);

/// Buildings that `join` wrote, and missions that stand alone, as one JSON object on stdout.
void tell_joined(const std::vector<WrittenBuilding>& written);

/// A room's new name, as one JSON object on stdout.
void tell_renamed(const std::filesystem::path& store, const PlanRoom& was, const std::string& name);

/// What `map` made, as one JSON object on stdout.
void tell_mapped(const Mapped& mapped, const std::filesystem::path& store);

/// The files that were written: as text, or as one JSON object. On stdout.
void tell_files(const Settings& settings, const std::filesystem::path& folder,
                const std::vector<std::string>& files);

}  // namespace roomatlas::apps
