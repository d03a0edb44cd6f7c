// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace roomatlas {

/// A table of weights; every row has the same length.
using WeightTable = std::vector<std::vector<double>>;

/// The one-to-one assignment of rows to columns with the greatest sum of weights (H. W. Kuhn, "The
/// Hungarian method for the assignment problem", 1955; here by shortest augmenting paths). Pairs of
/// weight 0 or less are never made.
/// @returns the column of each row, or nothing
[[nodiscard]] std::vector<std::optional<std::size_t>> best_assignment(const WeightTable& weights);

}  // namespace roomatlas
