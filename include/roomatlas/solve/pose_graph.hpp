// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "roomatlas/core/pose2.hpp"

namespace roomatlas {

/// What a measurement is, and with that whether robust estimation may reject it.
enum class EdgeKind : std::uint8_t {
  odometry,  ///< never rejected
  loop,      ///< a closure: rejected where it contradicts the others
  trusted,   ///< a closure that is known to be right, such as a shared pivot: never rejected
};

/// A measured pose of one node in the frame of another.
struct PoseEdge {
  std::int32_t from = 0;  ///< index into PoseGraph::ids, not an id
  std::int32_t to = 0;
  EdgeKind kind = EdgeKind::loop;
  Pose2 from_from_to;
  /// Inverse covariance of (x, y, theta) in the frame of the measured pose: 1/m^2, 1/(m rad),
  /// 1/rad^2. Symmetric, no negative eigenvalue.
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();
  /// Of a robust loss: an edge that is off by so many standard deviations counts half as much, and
  /// ever less beyond. 0: none, the edge counts in full however far off it is.
  double cauchy_sigmas = 0.0;
};

/// A measured heading of one node in the frame of the poses, such as a compass gives it, or walls
/// that follow a building's direction.
struct HeadingPrior {
  std::int32_t node = 0;  ///< index into PoseGraph::ids
  double theta_rad = 0.0;
  double sigma_rad = 0.0;       ///< > 0
  bool modulo_quarter = false;  ///< measured but for quarter turns: what is nearest at the guess
                                ///< counts, without a guess nearest to the headings of the edges
  double cauchy_sigmas = 0.0;   ///< as that of an edge
};

/// Poses to be found and the measurements between them; any graph.
struct PoseGraph {
  std::vector<std::int64_t> ids;  ///< of the nodes, each once; what messages name
  std::vector<Pose2> guess;       ///< one a node, or empty: the solver needs none
  std::vector<PoseEdge> edges;
  /// A component with any of these turns as they say; without, its fixed node's heading holds it.
  std::vector<HeadingPrior> headings = {};
};

/// g2o's error of a measurement:
///   [ R_ij' (R_i' (t_j - t_i) - t_ij) ; wrap(theta_j - theta_i - theta_ij) ]
[[nodiscard]] Eigen::Vector3d edge_error(const PoseEdge& edge, const Pose2& from, const Pose2& to);

/// error' * information * error, without a factor of one half. [0, inf)
[[nodiscard]] double chi_square(const PoseEdge& edge, const Pose2& from, const Pose2& to);

/// What a chi-square counts under Cauchy's loss: c^2 log(1 + chi-square / c^2), c in standard
/// deviations. Without a loss (0) the chi-square itself.
[[nodiscard]] double cauchy_loss(double chi_square, double cauchy_sigmas);

/// The weight that gives the same pull: the loss's derivative. (0, 1]
[[nodiscard]] double cauchy_weight(double chi_square, double cauchy_sigmas);

/// The squared error of a measured heading over its variance, without its loss. [0, inf)
[[nodiscard]] double chi_square(const HeadingPrior& prior, const Pose2& pose);

/// The sum over all edges and headings, each under its loss. @param poses one a node
[[nodiscard]] double chi_square(const PoseGraph& graph, std::span<const Pose2> poses);

/// What is wrong with an edge by itself, in words, or empty: a number that is not finite, or an
/// information matrix that is not symmetric or has a negative eigenvalue.
[[nodiscard]] std::string problem_of(const PoseEdge& edge);

/// Throws InputError naming the edge when an index is out of range, an edge joins a node with
/// itself, a number is not finite, or an information matrix is not symmetric or has a negative
/// eigenvalue; or the node of a heading whose node is out of range, a number not finite or a sigma
/// not positive; and when an id stands twice or `guess` is neither empty nor one a node.
void check(const PoseGraph& graph);

}  // namespace roomatlas
