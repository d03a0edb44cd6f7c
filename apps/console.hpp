// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "roomatlas/core/issue.hpp"
#include "roomatlas/core/progress.hpp"
#include "roomatlas/odometry/habits.hpp"
#include "roomatlas/plan/seen_last.hpp"
#include "settings.hpp"

namespace roomatlas::apps {

/// Sends messages to stderr as the settings ask; with --quiet errors alone, and nothing to stdout
/// but what --json prints.
void set_up_console(const Settings& settings);

/// Progress on stderr, with the time left: one line that is overwritten on a terminal; elsewhere
/// one line a stage, and one each 10 s; none with --quiet. Says stop after Ctrl-C or SIGTERM, which
/// are caught as long as it or a copy lives: a second one ends the process at once, as the first
/// does where nobody asks.
[[nodiscard]] Progress console_progress(const Settings& settings);

/// Shows warnings and errors, the first three of a kind (those that differ by numbers and names
/// alone), and how many more there are. Notes are counted, and shown with --verbose.
void show(const Issues& issues, std::int64_t not_listed = 0);

/// What is drawn as later missions saw it, a line for each of them.
void show(const std::vector<SeenLast>& seen_last, const std::filesystem::path& store);

/// Bias, gain and scale in words.
[[nodiscard]] std::string describe(const OdometryHabits& habits);

}  // namespace roomatlas::apps
