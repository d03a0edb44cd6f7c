// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "roomatlas/evaluate/evaluation.hpp"
#include "settings.hpp"

namespace roomatlas::apps {

/// Adds a truth file: told by its name where that ends (with .gz or without) in .relations,
/// .geojson or .json (a plan), .pgm (room labels) or .csv (tape-measure spans), else by content as
/// anything that holds a trajectory. Throws InputError when it holds nothing.
void add_truth(const std::filesystem::path& file, const Settings& settings, Truth& truth);

/// A truth file, and of which of several missions it is.
struct NamedTruth {
  std::string mission;  ///< empty: of all
  std::filesystem::path file;
};
/// Of an argument FILE or MISSION=FILE; what is a file as it stands is one.
[[nodiscard]] NamedTruth named_truth(const std::filesystem::path& argument);

/// All of them together.
/// @param files each as `named_truth` takes it
[[nodiscard]] Truth read_truth(const std::vector<std::filesystem::path>& files,
                               const Settings& settings);

/// @throws InputError for one that is not there, so that this is said before anything is mapped
void require_truth_files(const std::vector<std::filesystem::path>& files);

/// A file's ending, without .gz: ".pgm" of "labels.pgm.gz".
[[nodiscard]] std::string kind_of(const std::filesystem::path& file);

/// The names of files, without folders, for a heading.
[[nodiscard]] std::string names_of(const std::vector<std::filesystem::path>& files);

}  // namespace roomatlas::apps
