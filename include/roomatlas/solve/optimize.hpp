// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

#include "roomatlas/core/issue.hpp"
#include "roomatlas/solve/pose_graph.hpp"

namespace roomatlas {

enum class PoseGraphSolver {
  block,  ///< our factorisation of 3x3 blocks; Ceres where it fails
  ceres,  ///< the reference: same answer, slower
};

struct OptimizeOptions {
  PoseGraphSolver solver = PoseGraphSolver::block;
  /// Rejects closures that contradict odometry and each other. Without it all edges count.
  bool robust = false;
  /// Covariances cost about two factorisations more.
  bool covariance = false;
  /// Iterations of one solve. Graphs that are not solved after a few dozen never are.
  int max_iterations = 100;
};

/// Why an edge was kept or not.
enum class EdgeReason : std::uint8_t {
  not_decided,
  least_squares,   ///< no robust estimation was asked for
  reweighted,      ///< the same, and the edge has a loss
  never_rejected,  ///< odometry or trusted
  fits,            ///< a closure that agrees with the others
  contradicts,     ///< a closure that does not
};

struct EdgeVerdict {
  /// In the final solution: 1 kept, 0 rejected; of a loss, what it leaves of a kept edge.
  double weight = -1.0;
  double chi_square = -1.0;  ///< at the final poses, whether kept or not
  bool accepted = false;
  EdgeReason reason = EdgeReason::not_decided;
};

/// What became of a measured heading.
struct HeadingVerdict {
  double weight = -1.0;      ///< in the final solution, (0, 1]
  double chi_square = -1.0;  ///< at the final poses, without its loss
  double theta_rad = 0.0;    ///< what it was taken to say: quarter turns are settled
};

/// The reason in words, with the figures.
[[nodiscard]] std::string words(const EdgeVerdict& verdict);

/// What chi-square should be if the information matrices are right.
struct ChiSquareRange {
  std::int64_t degrees_of_freedom = 0;
  double low = 0.0;   ///< quantile 0.0005
  double high = 0.0;  ///< quantile 0.9995
};

struct PoseCovariance {
  /// Of each node's pose in the frame of its component's fixed node: x, y, theta in m, m, rad.
  /// Where headings are measured, in the frame of the poses, with the fixed node's position held.
  std::vector<Eigen::Matrix3d> of_node;
  /// Of the pose of `to` in the frame of `from`, for each edge.
  std::vector<Eigen::Matrix3d> of_edge;
};

struct OptimizeResult {
  std::vector<Pose2> poses;  ///< one a node; the fixed node of a component keeps its guess
  bool converged = false;
  bool trusted = false;  ///< no warning speaks against the result
  std::string message;   ///< which solver, and why it stopped
  /// At the guess; without one along a spanning tree. Over all edges.
  double initial_chi_square = -1.0;
  double chi_square = -1.0;  ///< over the accepted edges and all headings, under their losses
  int iterations = 0;        ///< linear systems solved, all starts and rounds together
  ChiSquareRange expected;   ///< for the accepted edges
  std::vector<EdgeVerdict> edges;
  std::vector<HeadingVerdict> headings;
  std::vector<std::int32_t> component;  ///< of each node, numbered by lowest id
  /// Node of each component that does not move, nor turn but where headings are measured.
  std::vector<std::int32_t> fixed;
  PoseCovariance covariance;  ///< empty unless asked for
  Issues issues;              ///< warnings speak against the result, notes do not
};

/// Poses that minimise the chi-square of a pose graph. Needs no guess: headings from a global
/// linear problem, positions with the first Gauss-Newton step. Each connected component has its
/// own fixed node, that of lowest id. The order of nodes and edges does not matter but for
/// rounding. Losses are minimised by iteratively reweighted least squares, from the guess (without
/// one, odometry) and from the global start; the lower minimum is kept.
/// Throws InputError as `check` does, and NotEnoughError when the graph has no edge, or numbers so
/// large that the solution is not finite.
/// Not guaranteed: that the minimum is global. Several starts are tried where closed loops show
/// that a rotation was wrapped wrongly.
[[nodiscard]] OptimizeResult optimize(const PoseGraph& graph, const OptimizeOptions& options);

}  // namespace roomatlas
