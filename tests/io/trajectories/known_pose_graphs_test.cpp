// SPDX-License-Identifier: GPL-3.0-or-later
// Recorded pose graphs whose best chi-square is known from other solvers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "roomatlas/io/trajectories/pose_graph_file.hpp"
#include "roomatlas/solve/optimize.hpp"
#include "support/false_loops.hpp"
#include "support/shared_data.hpp"

namespace roomatlas {
namespace {

struct Known {
  const char* file;
  double chi_square;
};

void PrintTo(const Known& known, std::ostream* out) { *out << known.file; }

class KnownPoseGraph : public ::testing::TestWithParam<Known> {
 protected:
  void SetUp() override {
    const auto file = test::shared_data(std::string("posegraphs/") + GetParam().file);
    if (file) graph_ = read_pose_graph(*file).graph;
  }
  void expect_best(const PoseGraph& graph, PoseGraphSolver solver) const {
    OptimizeOptions options;
    options.solver = solver;
    const OptimizeResult result = optimize(graph, options);
    EXPECT_NEAR(result.chi_square, GetParam().chi_square, 1e-5 * GetParam().chi_square);
    EXPECT_NEAR(chi_square(graph, result.poses), result.chi_square, 1e-9 * result.chi_square);
    EXPECT_TRUE(result.trusted);
  }
  [[nodiscard]] PoseGraph along_odometry() const {
    PoseGraph graph = graph_;
    graph.guess.assign(graph.ids.size(), {});
    std::vector<const PoseEdge*> into(graph.ids.size(), nullptr);
    for (const PoseEdge& edge : graph.edges) {
      if (std::abs(edge.from - edge.to) == 1) {
        into[static_cast<std::size_t>(std::max(edge.from, edge.to))] = &edge;
      }
    }
    for (std::size_t i = 1; i < graph.guess.size(); ++i) {
      if (into[i] == nullptr) continue;
      const bool forwards = into[i]->from < into[i]->to;
      graph.guess[i] =
          graph.guess[i - 1] * (forwards ? into[i]->from_from_to : inverse(into[i]->from_from_to));
    }
    return graph;
  }

  PoseGraph graph_;
};

TEST_P(KnownPoseGraph, IsSolvedFromTheGuessOfTheFile) {
  if (graph_.ids.empty()) return;
  expect_best(graph_, PoseGraphSolver::block);
}

TEST_P(KnownPoseGraph, IsSolvedFromOdometry) {
  if (graph_.ids.empty()) return;
  expect_best(along_odometry(), PoseGraphSolver::block);
}

TEST_P(KnownPoseGraph, IsSolvedWithoutAnyGuess) {
  if (graph_.ids.empty()) return;
  graph_.guess.clear();
  expect_best(graph_, PoseGraphSolver::block);
}

TEST_P(KnownPoseGraph, IsSolvedTheSameByCeres) {
  if (graph_.ids.empty()) return;
  expect_best(graph_, PoseGraphSolver::ceres);
}

TEST_P(KnownPoseGraph, LosesNoTrueClosureAndKeepsNoFalseOne) {
  if (graph_.ids.empty()) return;
  const PoseGraph graph = test::with_false_loops(graph_, 0.1, test::FalseLoops::grouped, 1);
  const OptimizeResult best = optimize(graph_, {});
  OptimizeOptions options;
  options.robust = true;
  const OptimizeResult result = optimize(graph, options);
  EXPECT_LT(test::aligned_rmse_m(result.poses, best.poses), 0.02);
  EXPECT_TRUE(result.trusted);
  std::ptrdiff_t true_rejected = 0;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    if (e >= graph_.edges.size()) {
      EXPECT_FALSE(result.edges[e].accepted);
    } else {
      true_rejected += result.edges[e].accepted ? 0 : 1;
    }
  }
  const auto loops = std::ranges::count(graph_.edges, EdgeKind::loop, &PoseEdge::kind);
  EXPECT_LE(50 * true_rejected, loops);
}

INSTANTIATE_TEST_SUITE_P(, KnownPoseGraph,
                         ::testing::Values(Known{"m3500_5453.g2o.gz", 137.912951},
                                           Known{"csail_1045.graph.gz", 38.956286},
                                           Known{"fr079_989.graph.gz", 37.599116},
                                           Known{"mitb_808.g2o.gz", 41.163269},
                                           Known{"manhattan3500_5598.g2o.gz", 146.07661},
                                           Known{"ring_434.g2o.gz", 11.163101},
                                           Known{"killian_1941.graph.gz", 10344.665}));

}  // namespace
}  // namespace roomatlas
