// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace roomatlas::apps {

/// What was wrong with a command line, what was probably meant, and where to look: lines for
/// stderr.
/// @param app the program, after its parsing ended with the error
[[nodiscard]] std::string explain(const CLI::App& app, const CLI::ParseError& error);

}  // namespace roomatlas::apps
