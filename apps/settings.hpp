// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "parameters.hpp"
#include "roomatlas/draw/draw.hpp"
#include "roomatlas/pipeline/options.hpp"
#include "roomatlas/simulate/explore.hpp"

namespace roomatlas::apps {

/// Everything that can be set, with the defaults of the stages.
struct Settings : Options {
  DrawOptions draw;
  SimulationOptions simulation;
  ExploreOptions explore;
  double png_dpi = 110.0;
  std::string add_closures;     ///< file of matches to be tried; empty: none
  std::string edits_file;       ///< statements to be applied; empty: those that the store keeps
  double label_pixel_m = 0.05;  ///< of label pictures given as truth
  bool force = false;           ///< maps anew, in the place of whatever store is there
  bool json = false;
  bool quiet = false;
  bool verbose = false;

  std::string as_toml;          ///< all parameters as set; filled after parsing
  std::set<std::string> given;  ///< names that stood on the command line or in its file
};

/// As without command line and configuration file.
[[nodiscard]] Settings default_settings();

/// What became of a configuration.
struct FromConfiguration {
  Settings settings;
  std::vector<std::string> unknown;  ///< names that no parameter has
};

/// The settings with some parameters from a configuration (TOML, a parameter a line, no sections),
/// whose lines `as_toml` has from then on, letter by letter.
/// @param settings complete: `as_toml` has all parameters
/// @param takes says by its name and stage whether a parameter is taken
/// @throws UsageError for a value that cannot be read, or one that is given twice
[[nodiscard]] FromConfiguration with_configuration(
    const Settings& settings, const std::string& toml,
    const std::function<bool(const std::string& name, Stage stage)>& takes);

/// Copies what two stages share, after parsing.
void share(Settings& settings);

}  // namespace roomatlas::apps
