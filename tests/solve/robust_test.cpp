// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "roomatlas/solve/optimize.hpp"
#include "support/generated_pose_graph.hpp"

namespace roomatlas {
namespace {

OptimizeResult robustly(const PoseGraph& graph) {
  OptimizeOptions options;
  options.robust = true;
  return optimize(graph, options);
}

struct Counts {
  int false_kept = 0;
  int true_rejected = 0;
};

/// False loops stand behind the edges of the clean graph.
Counts count(const PoseGraph& clean, const OptimizeResult& result) {
  Counts counts;
  for (std::size_t e = 0; e < result.edges.size(); ++e) {
    const bool is_false = e >= clean.edges.size();
    counts.false_kept += is_false && result.edges[e].accepted ? 1 : 0;
    counts.true_rejected += !is_false && !result.edges[e].accepted ? 1 : 0;
  }
  return counts;
}

TEST(Robust, KeepsEveryClosureOfACleanGraph) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const PoseGraph clean = test::walk_graph(300, 0.05, 0.03, seed).graph;
    const OptimizeResult result = robustly(clean);
    EXPECT_EQ(count(clean, result).true_rejected, 0);
    EXPECT_TRUE(result.trusted);
    const double plain = optimize(clean, {}).chi_square;
    EXPECT_NEAR(result.chi_square, plain, 1e-5 * plain);
  }
}

TEST(Robust, RejectsFalseLoopsHoweverTheyAreGrouped) {
  for (const auto kind :
       {test::FalseLoops::single, test::FalseLoops::grouped, test::FalseLoops::consistent}) {
    for (const double share : {0.1, 0.3}) {
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const PoseGraph clean = test::walk_graph(300, 0.05, 0.03, seed).graph;
        const PoseGraph graph = test::with_false_loops(clean, share, kind, seed);
        ASSERT_GT(graph.edges.size(), clean.edges.size() + 3);
        const OptimizeResult result = robustly(graph);
        const Counts counts = count(clean, result);
        EXPECT_EQ(counts.false_kept, 0) << share << " seed " << seed;
        EXPECT_LE(counts.true_rejected, 2) << share << " seed " << seed;
        EXPECT_LT(test::aligned_rmse_m(result.poses, optimize(clean, {}).poses), 0.02);
      }
    }
  }
}

TEST(Robust, GivesEveryClosureAWeightAChiSquareAndAReason) {
  const PoseGraph clean = test::walk_graph(200, 0.05, 0.03, 1).graph;
  const PoseGraph graph = test::with_false_loops(clean, 0.1, test::FalseLoops::single, 1);
  const OptimizeResult result = robustly(graph);
  ASSERT_EQ(result.edges.size(), graph.edges.size());
  EXPECT_EQ(result.edges.front().reason, EdgeReason::never_rejected);
  EXPECT_EQ(result.edges[clean.edges.size() - 1].reason, EdgeReason::fits);
  const EdgeVerdict& rejected = result.edges.back();
  EXPECT_EQ(rejected.reason, EdgeReason::contradicts);
  EXPECT_EQ(rejected.weight, 0.0);
  const PoseEdge& edge = graph.edges.back();
  EXPECT_NEAR(rejected.chi_square,
              chi_square(edge, result.poses[static_cast<std::size_t>(edge.from)],
                         result.poses[static_cast<std::size_t>(edge.to)]),
              1e-6 * rejected.chi_square);
  EXPECT_NE(words(rejected).find("contradicts"), std::string::npos);
}

TEST(Robust, TrustedEdgesAreNeverRejected) {
  const PoseGraph clean = test::walk_graph(200, 0.05, 0.03, 2).graph;
  PoseGraph graph = test::with_false_loops(clean, 0.05, test::FalseLoops::single, 3);
  graph.edges.back().kind = EdgeKind::trusted;
  EXPECT_TRUE(robustly(graph).edges.back().accepted);
}

TEST(Robust, MostlyFalseClosuresAreSaidLoudly) {
  const PoseGraph clean = test::walk_graph(200, 0.05, 0.03, 2).graph;
  const PoseGraph graph = test::with_false_loops(clean, 1.5, test::FalseLoops::single, 3);
  EXPECT_FALSE(robustly(graph).trusted);
}

TEST(Robust, WorksWhereOdometryDoesNotReachEveryNode) {
  PoseGraph clean = test::walk_graph(200, 0.05, 0.03, 6).graph;
  std::erase_if(clean.edges, [](const PoseEdge& e) { return e.from == 99 && e.to == 100; });
  const PoseGraph graph = test::with_false_loops(clean, 0.05, test::FalseLoops::single, 3);
  EXPECT_EQ(count(clean, robustly(graph)).false_kept, 0);
}

}  // namespace
}  // namespace roomatlas
