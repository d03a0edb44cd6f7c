// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "roomatlas/evaluate/compare.hpp"
#include "roomatlas/evaluate/plan_figures.hpp"

namespace roomatlas::apps {

/// Where a comparison goes besides stdout; empty paths are not written.
struct ComparisonFiles {
  std::filesystem::path csv;
  std::filesystem::path latex;
  std::filesystem::path plots;    ///< a folder
  std::filesystem::path archive;  ///< in evo's layout
};

/// Tables for people, on stdout.
/// @param steps what was done to the trajectories before
void print(const Comparison& comparison, const std::vector<std::string>& steps);

/// Writes what was asked for. Several archives get the run's name and the metric's in their names.
/// Throws UsageError for plots or archives of nothing.
void write(const Comparison& comparison, const std::vector<JudgedPlan>& plans,
           const ComparisonFiles& files);

}  // namespace roomatlas::apps
