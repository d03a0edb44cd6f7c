// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "command_tree.hpp"

namespace roomatlas::apps {

/// How much of the help is shown.
enum class HelpSize {
  page,  ///< what fits a terminal of 80 columns and 40 lines
  all,   ///< every option and parameter
};

/// `roomatlas --help`: the commands and what all of them take. Lines of at most 80 columns.
[[nodiscard]] std::string help_of(const ProgramText& program, HelpSize size);

/// `roomatlas COMMAND --help`: its own options; with `all` the parameters of its stages too.
[[nodiscard]] std::string help_of(const CommandText& command, HelpSize size);

}  // namespace roomatlas::apps
