// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "plan_cases.hpp"
#include "plan_table.hpp"

namespace roomatlas::bench {

struct PlanRunOptions {
  bool simulate_again = false;  ///< and map; else a mission of the same arguments is taken again
  bool map_again = false;       ///< for a change of the online stage
  bool with_pictures = false;   ///< plan.svg beside the store
  Words assemble;               ///< more flags of `roomatlas assemble`
};

/// Simulates and maps a case where that was not done before with the same arguments, draws its
/// plan, and judges it.
/// @param out folder of all cases: each keeps its mission, its map and its plan in one below
[[nodiscard]] PlanRow run_plan_case(const PlanCase& one, const std::filesystem::path& out,
                                    const PlanRunOptions& options);

}  // namespace roomatlas::bench
