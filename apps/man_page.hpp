// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "command_tree.hpp"

namespace roomatlas::apps {

/// `roomatlas.1` in roff (man(7)): commands, options of all of them, parameters, exit status.
[[nodiscard]] std::string man_page(const ProgramText& program);

/// The page of a program that has no commands, such as `roomatlas-fleet.1`.
/// @param usage what follows its name
[[nodiscard]] std::string man_page_alone(const ProgramText& program, const std::string& usage);

/// `roomatlas-COMMAND.1`.
[[nodiscard]] std::string man_page(const ProgramText& program, const CommandText& command);

/// What `roomatlas man` was asked for.
struct ManArguments {
  std::string command;        ///< empty: the program's own page
  std::filesystem::path out;  ///< folder for all pages; empty: one page on stdout
};
void man(const ProgramText& program, const ManArguments& arguments);

}  // namespace roomatlas::apps
