// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "command_tree.hpp"

namespace roomatlas::apps {

/// The shells that completions are written for.
[[nodiscard]] std::vector<std::string> completion_shells();

/// A script that a shell reads to complete commands, options, names that options take, and files.
/// @param shell one of them
[[nodiscard]] std::string completion(const ProgramText& program, const std::string& shell);

}  // namespace roomatlas::apps
