// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "parameters.hpp"

namespace roomatlas::apps {

/// Heading above options that say where results go.
inline constexpr const char* kResults = "Results";

/// An invocation as somebody would type it.
struct Example {
  std::string line;
  std::string meaning;
};

/// What help and manual say of a command beside its options.
struct CommandNotes {
  std::string group;          ///< heading in the list of commands; empty: not listed
  std::vector<Stage> stages;  ///< whose parameters change what it does
  std::vector<Example> examples;
};

/// Throws std::logic_error for a command without notes.
[[nodiscard]] const CommandNotes& notes_of(const std::string& command);

}  // namespace roomatlas::apps
