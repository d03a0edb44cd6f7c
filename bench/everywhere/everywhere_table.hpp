// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace roomatlas::bench {

/// Bounds of a share from counts, 95 % (Wilson 1927).
struct Interval {
  double low = 0.0;
  double high = 1.0;
};
[[nodiscard]] Interval wilson(std::size_t hits, std::size_t count);

/// Markdown: rows by stratum, then by building, sensor and fault within each stratum, and the worst
/// cases with the command that repeats them.
[[nodiscard]] std::string everywhere_table(const std::vector<nlohmann::json>& cases);

/// One line on one case, for who watches.
[[nodiscard]] std::string everywhere_line(const nlohmann::json& one);

}  // namespace roomatlas::bench
