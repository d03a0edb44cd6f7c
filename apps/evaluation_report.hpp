// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "roomatlas/evaluate/evaluation.hpp"
#include "settings.hpp"
#include "trajectory_flags.hpp"

namespace roomatlas::apps {

/// Judges an assembled store against true poses in it, the given truth files, and itself.
[[nodiscard]] Evaluation evaluation_of(const Settings& settings, const std::filesystem::path& store,
                                       const std::vector<std::filesystem::path>& truth,
                                       const TrajectoryFlags& flags);

/// Tables for people, on stdout.
void print(const Evaluation& evaluation);

}  // namespace roomatlas::apps
