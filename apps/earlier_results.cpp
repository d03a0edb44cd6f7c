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

/// How the names of results begin; stores that stay beside begin as stores do, and are told of when
/// they are put there.
bool is_named_as_a_result(const std::string& name) {
  constexpr std::array<std::string_view, 12> kBegins = {"plan.",
                                                        "before_after.",
                                                        "trajectory_odometry",
                                                        "trajectory_corrected",
                                                        "rooms.",
                                                        "graph.g2o",
                                                        "route_graph.",
                                                        "building.yaml",
                                                        "missions",
                                                        "beside",
                                                        "map.",
                                                        "keepout_mask."};
  return std::any_of(kBegins.begin(), kBegins.end(),
                     [&](std::string_view begin) { return name.starts_with(begin); });
}

}  // namespace

void tell_earlier_results(const std::filesystem::path& folder,
                          const std::vector<std::string>& written) {
  const std::set<std::string> now(written.begin(), written.end());
  std::vector<std::string> earlier;
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable)) {
    std::string name = entry.path().filename().string();
    if (is_named_as_a_result(name) && !now.contains(name)) earlier.push_back(std::move(name));
  }
  if (earlier.empty()) return;
  std::sort(earlier.begin(), earlier.end());
  spdlog::warn("{}: of an earlier run, and not written now: {}", folder.string(),
               fmt::join(earlier, ", "));
}

}  // namespace roomatlas::apps
