// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/evaluate/compare.hpp"

#include <string>

namespace roomatlas {

/// A comparison as one JSON object: what was used, and all figures, run by run. Statistics of
/// nothing are null.
[[nodiscard]] std::string to_json(const Comparison& comparison);

/// One line a figure, with a heading line; RFC 4180. Numbers in their shortest form that reads
/// back to the same double, empty where there is none.
[[nodiscard]] std::string to_csv(const Comparison& comparison);

/// A `tabular` for \usepackage{booktabs}: a line a run, mean and interval of each figure that has
/// one. Names are escaped.
[[nodiscard]] std::string to_latex(const Comparison& comparison);

}  // namespace roomatlas
