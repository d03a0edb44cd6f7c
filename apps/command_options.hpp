// SPDX-License-Identifier: GPL-3.0-or-later
// What commands take on the command line, beside the parameters of the stages.
#pragma once

#include <CLI/CLI.hpp>

#include <vector>

#include "commands.hpp"

namespace roomatlas::apps {

/// Files of truth, and how trajectories are compared with them.
struct TruthArguments {
  std::vector<Path> truth;
  std::vector<Path> spans;
  TrajectoryFlags trajectory;

  /// All files: spans are told by their names too.
  [[nodiscard]] std::vector<Path> files() const {
    std::vector<Path> all = truth;
    all.insert(all.end(), spans.begin(), spans.end());
    return all;
  }
};

/// Its value is one, with a slash at the end or without.
CLI::Option* folder_or_file(CLI::Option* option);
CLI::Option* positionals(CLI::App* command, const char* name, std::vector<Path>& values,
                         const char* meaning);
CLI::Option* positional(CLI::App* command, const char* name, Path& value, const char* meaning);
CLI::Option* output(CLI::App* command, Path& value, const char* meaning);
CLI::Option* output_folder(CLI::App* command, Path& value, const char* meaning);
void add_export_options(CLI::App* command, ExportOptions& options);
void add_measured_walls(CLI::App* command, ExportOptions& options);
void add_ogr_option(CLI::App* command, ExportOptions& options);
void add_address_option(CLI::App* command, ExportOptions& options);
void add_storey_height(CLI::App* command, ExportOptions& options);
void add_truth(CLI::App* command, TruthArguments& arguments);
void add_simulate(CLI::App* command, SimulateArguments& arguments);
void add_comparison_files(CLI::App* command, ComparisonFiles& files);
void add_optimize(CLI::App* command, OptimizeArguments& arguments);
void add_locate(CLI::App* command, LocateArguments& arguments);
void add_compare(CLI::App* command, CompareArguments& arguments);

}  // namespace roomatlas::apps
