// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "drawn_case.hpp"

namespace roomatlas::bench {

/// Simulates a case, builds its map and judges it. Whatever fails is a figure: "failure" says what,
/// and "right" is false then. A mission that could not be simulated has "drawn" false.
/// @param folder of this case alone; what is in it is replaced
[[nodiscard]] nlohmann::json run_case(const DrawnCase& drawn, const std::filesystem::path& folder);

/// What is known of a case before it is run, and all that is left of one that ended the process.
[[nodiscard]] nlohmann::json description_of(const DrawnCase& drawn);

}  // namespace roomatlas::bench
