// SPDX-License-Identifier: GPL-3.0-or-later
// The normal equations of the batch.
#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

#include "roomatlas/solve/block_cholesky.hpp"
#include "sonar_factors.hpp"

namespace roomatlas {

/// Where in the matrix stands what two nodes say of themselves and of each other. Looked up once
/// for all residuals between them.
struct PairPlaces {
  std::size_t first = 0;   ///< position of the node
  std::size_t second = 0;  ///< position of the other node
  BlockPlace of_first;
  BlockPlace of_second;
  BlockPlace of_both;  ///< its rows are those of the node with the greater position
};

/// What touches every node: odometry's lengths as a whole, and the directions of the building's
/// walls, of which the first stays as it is.
struct SharedUnknowns {
  double length_scale = 1.0;
  std::vector<double> directions_rad;
};

/// Normal equations of the nodes for one set of pairs, and of what they share. That touches every
/// node: it stands beside the sparse matrix, not in it.
class SonarEquations {
 public:
  /// @param pairs of nodes that residuals join
  /// @param directions of the building's walls, the first included; at least one
  SonarEquations(std::size_t nodes, const std::vector<NodePair>& pairs, std::size_t directions)
      : supernodes_(find_supernodes(nodes, pairs)),
        matrix_(supernodes_),
        nodes_(nodes),
        shared_(static_cast<Eigen::Index>(directions)) {}

  void clear();

  /// @param first,second one of the pairs; not one node
  [[nodiscard]] PairPlaces places_of(std::size_t first, std::size_t second) const;

  /// Adds weight times the square of a residual of one node's heading against a direction.
  void add_heading(std::size_t node, std::size_t direction, double residual, double weight);
  /// The same of a direction alone, not the first.
  void add_direction(std::size_t direction, double residual, double weight);

  /// The same of a residual between two nodes.
  void add(const PairPlaces& places, const PairResidual& residual, double weight) {
    add_square(places.of_first, residual.by_first, weight);
    add_square(places.of_second, residual.by_second, weight);
    if (places.first > places.second) {
      add_product(places.of_both, residual.by_first, residual.by_second, weight);
    } else {
      add_product(places.of_both, residual.by_second, residual.by_first, weight);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      right_side_[3 * places.first + i] -= weight * residual.value * residual.by_first[i];
      right_side_[3 * places.second + i] -= weight * residual.value * residual.by_second[i];
    }
  }
  /// The same of the turn from the second node to the first, whose derivatives are 1 and -1.
  void add_turn(const PairPlaces& places, double residual, double weight) {
    heading_of(places.of_first) += weight;
    heading_of(places.of_second) += weight;
    heading_of(places.of_both) -= weight;
    right_side_[3 * places.first + 2] -= weight * residual;
    right_side_[3 * places.second + 2] += weight * residual;
  }
  /// What a residual that was added says of the scale, too.
  void add_scale(const PairPlaces& places, const PairResidual& residual, double by_scale,
                 double weight);
  void add_scale(double residual, double by_scale, double weight);
  /// Holds a node where it is.
  void hold(std::size_t node, double weight);

  /// Moves the poses. @return root mean square of the moves; negative when the system is singular
  [[nodiscard]] double solve(std::vector<Pose2>& map_from_node, SharedUnknowns& shared);
  /// Moves of the nodes (x, y, heading of each) as likely as the equations leave them, whatever
  /// they share is, as last solved: their covariance is that of the estimate.
  [[nodiscard]] std::vector<double> draw_moves(std::mt19937_64& random) const;
  /// Standard deviation of the scale, whatever all else is, as last solved.
  [[nodiscard]] double scale_sigma() const { return std::sqrt(shared_covariance_(kScale, kScale)); }

 private:
  [[nodiscard]] std::size_t position(std::size_t node) const {
    return static_cast<std::size_t>(supernodes_.position[node]);
  }
  [[nodiscard]] BlockPlace place(std::size_t row, std::size_t column) const {
    return matrix_.place(static_cast<std::int32_t>(row), static_cast<std::int32_t>(column));
  }
  [[nodiscard]] double& heading_of(const BlockPlace& place) {
    return matrix_.values()[place.offset + 2 + 2 * std::ptrdiff_t{place.stride}];
  }
  /// To a block on the diagonal, of which the lower part alone is read.
  void add_square(const BlockPlace& place, const std::array<double, 3>& by, double weight) {
    double* const block = matrix_.values() + place.offset;
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = j; i < 3; ++i) {
        block[i + j * static_cast<std::size_t>(place.stride)] += weight * by[i] * by[j];
      }
    }
  }
  void add_product(const BlockPlace& place, const std::array<double, 3>& by_row,
                   const std::array<double, 3>& by_column, double weight) {
    double* const block = matrix_.values() + place.offset;
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = 0; i < 3; ++i) {
        block[i + j * static_cast<std::size_t>(place.stride)] += weight * by_row[i] * by_column[j];
      }
    }
  }
  [[nodiscard]] Eigen::VectorXd eliminate_shared();

  static constexpr Eigen::Index kScale = 0;  ///< where the first direction would stand

  Supernodes supernodes_;
  BlockCholesky<3> matrix_;
  std::size_t nodes_;
  Eigen::Index shared_;
  std::vector<double> right_side_;
  Eigen::MatrixXd by_shared_;       ///< of the normal matrix, the columns of what is shared
  Eigen::MatrixXd node_by_shared_;  ///< how the nodes move with it, as last solved
  Eigen::MatrixXd shared_weight_;
  Eigen::VectorXd shared_right_;
  Eigen::MatrixXd shared_covariance_;  ///< as last solved
};

}  // namespace roomatlas
