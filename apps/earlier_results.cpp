// SPDX-License-Identifier: GPL-3.0-or-later
#include "earlier_results.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

namespace roomatlas::apps {
namespace {

/// "building.2.gpkg": of missions that the others did not join.
bool is_another_building(const std::string& name) {
  constexpr std::string_view kBegin = "building.";
  constexpr std::string_view kEnd = ".gpkg";
  if (!name.starts_with(kBegin) || !name.ends_with(kEnd)) return false;
  const std::size_t until = name.size() - kEnd.size();
  return until > kBegin.size() && name.find_first_not_of("0123456789", kBegin.size()) == until;
}

/// How the names of results begin; stores that stay beside begin as stores do, and are told of when
/// they are put there.
bool is_named_as_a_result(const std::string& name) {
  constexpr std::array<std::string_view, 11> kBegins = {
      "plan.",    "before_after.", "trajectory_odometry", "trajectory_corrected",
      "rooms.",   "graph.g2o",     "route_graph.",        "building.yaml",
      "missions", "map.",          "keepout_mask."};
  return is_another_building(name) ||
         std::any_of(kBegins.begin(), kBegins.end(),
                     [&](std::string_view begin) { return name.starts_with(begin); });
}

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable)) {
    names.push_back(entry.path().filename().string());
  }
  return names;
}

/// Those of plans that stand beside another as "beside/NAME".
std::vector<std::string> results_in(const std::filesystem::path& folder) {
  std::vector<std::string> results = names_in(folder);
  std::erase_if(results, [](const std::string& name) { return !is_named_as_a_result(name); });
  for (const std::string& name : names_in(folder / "beside")) results.push_back("beside/" + name);
  std::sort(results.begin(), results.end());
  return results;
}

}  // namespace

void tell_earlier_results(const std::filesystem::path& folder,
                          const std::vector<std::string>& written) {
  const std::set<std::string> now(written.begin(), written.end());
  std::vector<std::string> earlier = results_in(folder);
  std::erase_if(earlier, [&](const std::string& name) { return now.contains(name); });
  if (earlier.empty()) return;
  spdlog::warn("{}: of an earlier run, and not written now: {}", folder.string(),
               fmt::join(earlier, ", "));
}

}  // namespace roomatlas::apps
