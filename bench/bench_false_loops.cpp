// SPDX-License-Identifier: GPL-3.0-or-later
// False loops added to recorded pose graphs: what robust estimation keeps and rejects, and how far
// the result is from that of the clean graph.
// Arguments: seeds (1), beginning of the graphs' names (all).
#include <glog/logging.h>

#include <chrono>
#include <cstdio>

#include "posegraph_files.hpp"
#include "roomatlas/io/trajectories/pose_graph_file.hpp"
#include "roomatlas/solve/optimize.hpp"
#include "support/false_loops.hpp"

namespace roomatlas {
namespace {

struct Score {
  double rmse_m = 0.0;
  int false_kept = 0;
  int true_rejected = 0;
  bool warned = false;
  double seconds = 0.0;
};

Score score(const PoseGraph& clean, const PoseGraph& graph, const std::vector<Pose2>& best) {
  const auto start = std::chrono::steady_clock::now();
  OptimizeOptions options;
  options.robust = true;
  const OptimizeResult result = optimize(graph, options);
  Score score;
  score.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  score.rmse_m = test::aligned_rmse_m(result.poses, best);
  score.warned = !result.trusted;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const bool is_false = e >= clean.edges.size();
    score.false_kept += is_false && result.edges[e].accepted ? 1 : 0;
    score.true_rejected += !is_false && !result.edges[e].accepted ? 1 : 0;
  }
  return score;
}

/// What was added to a graph.
struct Added {
  const char* kind = "none";
  double share = 0.0;
  std::uint64_t seed = 0;
  std::size_t edges = 0;
};

void print(const std::string& name, const Added& added, const Score& s) {
  std::printf("%-26s %-10s %3.0f %% %4d | %9.4f %5d of %4zu %5d %8s %8.2f\n", name.c_str(),
              added.kind, 100.0 * added.share, static_cast<int>(added.seed), s.rmse_m, s.false_kept,
              added.edges, s.true_rejected, s.warned ? "warned" : "-", s.seconds);
  std::fflush(stdout);
}

}  // namespace
}  // namespace roomatlas

int main(int argc, char** argv) {
  using namespace roomatlas;
  FLAGS_minloglevel = google::GLOG_FATAL;
  google::InitGoogleLogging(argv[0]);
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 1;
  const std::string only = argc > 2 ? argv[2] : "";  // graphs whose name begins so
  std::printf("%-26s %-10s %5s %4s | %9s %13s %5s %8s %8s\n", "graph", "false", "share", "seed",
              "RMSE m", "false kept", "true-", "warning", "s");
  constexpr struct {
    test::FalseLoops kind;
    const char* name;
  } kKinds[] = {{test::FalseLoops::single, "single"},
                {test::FalseLoops::grouped, "grouped"},
                {test::FalseLoops::consistent, "consistent"}};
  for (const auto& file : bench::pose_graph_files()) {
    if (!bench::short_name(file).starts_with(only)) continue;
    const PoseGraph clean = read_pose_graph(file).graph;
    const std::vector<Pose2> best = optimize(clean, {}).poses;
    const std::string name = bench::short_name(file);
    print(name, {}, score(clean, clean, best));
    for (const double share : {0.1, 0.3}) {
      for (const auto& [kind, kind_name] : kKinds) {
        for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(seeds); ++seed) {
          const PoseGraph graph = test::with_false_loops(clean, share, kind, seed);
          const std::size_t added = graph.edges.size() - clean.edges.size();
          print(name, {kind_name, share, seed, added}, score(clean, graph, best));
        }
      }
    }
  }
  return 0;
}
