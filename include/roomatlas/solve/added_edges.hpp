// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "roomatlas/solve/pose_graph.hpp"

namespace roomatlas {

/// The largest variances among the nodes of a pose graph, each relative to the fixed node of its
/// component as `PoseCovariance::of_node` has them, or after the whole was laid on where it is.
struct LargestVariance {
  double position_m2 = 0.0;   ///< of a node's position along its loosest axis
  double heading_rad2 = 0.0;  ///< of a node's heading
};

/// What further measurements would do to a pose graph's covariance, wherever they turned out: the
/// update of a Kalman filter (Ila, Porta, Andrade-Cetto 2010, "Information-based compact Pose
/// SLAM"), which needs the covariance alone and no new solve.
class AddedEdges {
 public:
  /// @param graph with a guess, at which it is linearised and its losses weigh
  /// Memory is quadratic in the nodes (72 bytes a pair), time about so too.
  explicit AddedEdges(const PoseGraph& graph);

  /// By solutions that were drawn instead, as a sample of what is left open; no node is fixed.
  /// @param at of each node
  /// @param moves of each node, as many of each: its pose in every draw, in the frame of `at`
  /// @throws std::invalid_argument where the numbers differ
  AddedEdges(std::vector<Pose2> at, const std::vector<std::vector<Pose2>>& moves);

  /// False where the measurements hold the nodes of no component; nothing else may be asked then.
  [[nodiscard]] bool is_held() const { return covariance_.size() > 0; }
  [[nodiscard]] LargestVariance now() const;
  /// Of the pose of `to` in the frame of `from`, along the axes of `to`.
  [[nodiscard]] Eigen::Matrix3d relative(std::int32_t from, std::int32_t to) const;
  /// Were these measured too, where the nodes are. Their poses and losses do not count.
  [[nodiscard]] LargestVariance with(std::span<const PoseEdge> edges) const;
  /// They are, from now on.
  void add(std::span<const PoseEdge> edges);

 private:
  /// What the edges see of all nodes: 3 rows an edge of what is taken from the covariance as
  /// reduction' reduction.
  [[nodiscard]] Eigen::MatrixXd reduction(std::span<const PoseEdge> edges) const;

  std::vector<Pose2> at_;
  Eigen::MatrixXd covariance_;  ///< 3 rows and columns a node: x, y (m), theta (rad), poses' frame
};

}  // namespace roomatlas
