// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

#include "roomatlas/draw/draw.hpp"
#include "roomatlas/pipeline/options.hpp"
#include "roomatlas/simulate/explore.hpp"

namespace CLI {
class App;
}

namespace roomatlas::apps {

/// Everything that can be set, with the defaults of the stages.
struct Settings : Options {
  DrawOptions draw;
  SimulationOptions simulation;
  ExploreOptions explore;
  double png_dpi = 110.0;
  std::string add_closures;     ///< file of matches to be tried; empty: none
  double label_pixel_m = 0.05;  ///< of label pictures given as truth
  bool json = false;
  bool quiet = false;
  bool verbose = false;

  std::string as_toml;          ///< all parameters as set, filled after parsing
  std::set<std::string> given;  ///< names that stood on the command line or in its file
};

// Stages: the parameters of one stand under one heading of the help.
inline constexpr const char* kMissionStage = "Mission (what the log does not say)";
inline constexpr const char* kRoomsStage = "Rooms (online stage)";
inline constexpr const char* kCorrectionStage = "Correction (offline stage)";

/// Adds every parameter to the program, once: its flag, its key in the configuration file and its
/// line in `--help` and `config --print` come from here.
void add_parameters(CLI::App& app, Settings& settings);

/// Copies what two stages share, and keeps what was given, after parsing.
void complete(Settings& settings, const CLI::App& app);

}  // namespace roomatlas::apps
