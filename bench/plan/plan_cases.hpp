// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace roomatlas::bench {

using Words = std::vector<std::string>;

/// A mission whose plan is judged: simulated first, or recorded.
struct PlanCase {
  std::string group;             ///< whose rows stand together and have a mean of their own
  std::string name;              ///< such as "nine_rooms furnished laser"
  std::filesystem::path source;  ///< world or map to simulate a mission in, or a recorded log
  Words simulation;              ///< flags of `roomatlas simulate`; none for a recorded log
  std::filesystem::path labels;  ///< label picture that a recorded log is judged by

  [[nodiscard]] bool is_recorded() const { return simulation.empty(); }
};

/// All cases, in the order of the table: worlds, maps, fr079.
/// @param worlds folder of the shipped worlds
/// @param data folder of the recorded data
[[nodiscard]] std::vector<PlanCase> plan_cases(const std::filesystem::path& worlds,
                                               const std::filesystem::path& data);

/// Whether every word of `wish` is a word of the case's group or name. An empty wish is every
/// case's.
[[nodiscard]] bool is_wished(const PlanCase& one, const std::string& wish);

}  // namespace roomatlas::bench
