// SPDX-License-Identifier: GPL-3.0-or-later
// Generated walks whose headings are measured poorly: how often the solver ends above the minimum
// near the truth, and whether it warns then, and only then.
#include <glog/logging.h>

#include <cstdio>

#include "roomatlas/solve/optimize.hpp"
#include "support/generated_pose_graph.hpp"

int main(int, char** argv) {
  using namespace roomatlas;
  FLAGS_minloglevel = google::GLOG_FATAL;
  google::InitGoogleLogging(argv[0]);
  constexpr std::uint64_t kSeeds = 12;
  constexpr struct {
    std::int32_t nodes;
    double sigma_rad;
  } kWalks[] = {{250, 0.1}, {250, 0.2}, {250, 0.3}, {250, 0.4}, {250, 0.5}, {1000, 0.3}};
  std::printf("%6s %6s | %6s %6s %7s %14s\n", "nodes", "rad", "graphs", "wrong", "warned",
              "right, warned");
  for (const auto& [nodes, sigma_rad] : kWalks) {
    int wrong = 0;
    int warned = 0;
    int false_alarms = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      test::GeneratedGraph g = test::walk_graph(nodes, 0.1, sigma_rad, seed);
      const OptimizeResult result = optimize(g.graph, {});
      g.graph.guess = g.truth;
      const bool is_wrong = result.chi_square > optimize(g.graph, {}).chi_square * (1.0 + 1e-4);
      wrong += is_wrong ? 1 : 0;
      warned += is_wrong && !result.trusted ? 1 : 0;
      false_alarms += !is_wrong && !result.trusted ? 1 : 0;
    }
    std::printf("%6d %6.1f | %6d %6d %7d %14d\n", nodes, sigma_rad, static_cast<int>(kSeeds), wrong,
                warned, false_alarms);
    std::fflush(stdout);
  }
  return 0;
}
