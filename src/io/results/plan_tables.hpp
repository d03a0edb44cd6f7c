// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/evaluate/plan_figures.hpp"

#include <string>
#include <vector>

namespace roomatlas::io {

/// Lines with the columns of a comparison's CSV: metric and quantity say what, the value stands
/// under `mean`; run by run.
[[nodiscard]] std::string plan_csv_lines(const std::vector<JudgedPlan>& plans);

/// A `tabular` with a line a figure and a column a plan; empty without plans.
[[nodiscard]] std::string plan_latex(const std::vector<JudgedPlan>& plans);

}  // namespace roomatlas::io
