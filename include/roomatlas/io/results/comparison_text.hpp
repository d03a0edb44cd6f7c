// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/evaluate/compare.hpp"
#include "roomatlas/evaluate/plan_figures.hpp"

#include <string>
#include <vector>

namespace roomatlas {

/// A comparison as one JSON object: what was used, all figures of trajectories, run by run, and all
/// of plans, plan by plan. Statistics of nothing are null.
[[nodiscard]] std::string to_json(const Comparison& comparison,
                                  const std::vector<JudgedPlan>& plans = {});

/// One line a figure, with a heading line; RFC 4180. Numbers in their shortest form that reads
/// back to the same double, empty where there is none. A plan's figure has its value under `mean`.
[[nodiscard]] std::string to_csv(const Comparison& comparison,
                                 const std::vector<JudgedPlan>& plans = {});

/// One LaTeX `tabular` (package booktabs) with a line a run, mean and interval of each figure that
/// has one; behind it one with a column a plan. Names are escaped.
[[nodiscard]] std::string to_latex(const Comparison& comparison,
                                   const std::vector<JudgedPlan>& plans = {});

}  // namespace roomatlas
