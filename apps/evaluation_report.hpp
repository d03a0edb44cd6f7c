// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "roomatlas/pipeline/pipeline.hpp"
#include "trajectory_flags.hpp"

namespace roomatlas::apps {

/// Judges an assembled store against true poses in it and the given truth files. Nothing when
/// there is neither.
[[nodiscard]] std::optional<Evaluation> evaluation_of(
    const Settings& settings, const std::filesystem::path& store,
    const std::vector<std::filesystem::path>& truth, const TrajectoryFlags& flags);

/// Tables for people, on stdout.
void print(const Evaluation& evaluation);

}  // namespace roomatlas::apps
