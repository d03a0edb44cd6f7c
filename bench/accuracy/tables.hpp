// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program.hpp"

namespace roomatlas::bench {

/// A mission, mapped in one way.
struct Mapped {
  std::string mission;
  std::string variant;
  bool is_first_variant = false;  ///< its line of odometry stands for all variants
  Finished run;
  nlohmann::json summary;  ///< summary.json; null where the program failed
};

/// Markdown for docs/evaluation.md: relations, true poses, plans against true plans, and maps
/// against themselves. The same results give the same text.
[[nodiscard]] std::string accuracy_tables(const std::vector<Mapped>& all);

/// Time and memory, which differ from run to run.
[[nodiscard]] std::string cost_table(const std::vector<Mapped>& all);

}  // namespace roomatlas::bench
