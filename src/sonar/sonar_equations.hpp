// SPDX-License-Identifier: GPL-3.0-or-later
// The normal equations of the batch.
#pragma once

#include <Eigen/Core>
#include <cstdint>
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

constexpr std::size_t kClusterNodes = 36;  ///< whose residuals err together: some 10 m of path.
                                           ///< With a third, or three times as many, rooms that are
                                           ///< off are told nearly as well

/// What a residual is of.
enum class ResidualKind : std::uint8_t { step, heading, pair, range, prior };

/// Normal equations of the nodes for one set of pairs, and of what they share. That touches every
/// node: it stands beside the sparse matrix, not in it.
class SonarEquations {
 public:
  /// @param pairs of nodes that residuals join
  /// @param directions of the building's walls, the first included; at least one
  /// @param wild_draws that may be asked for, at most 64
  SonarEquations(std::size_t nodes, const std::vector<NodePair>& pairs, std::size_t directions,
                 int wild_draws = 0)
      : supernodes_(find_supernodes(nodes, pairs)),
        matrix_(supernodes_),
        nodes_(nodes),
        shared_(static_cast<Eigen::Index>(directions)),
        signs_(wild_draws) {}

  void clear();

  /// What is added from here on is of one kind, between two nodes, or of one. Residuals of a kind
  /// between two stretches of the path err together, as the wall, the ring and the drive there make
  /// them: they are a cluster of the wild bootstrap.
  void begin(ResidualKind kind, std::size_t first, std::size_t second);

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
      pull(3 * places.first + i, -weight * residual.value * residual.by_first[i]);
      pull(3 * places.second + i, -weight * residual.value * residual.by_second[i]);
    }
  }
  /// The same of the turn from the second node to the first, whose derivatives are 1 and -1.
  void add_turn(const PairPlaces& places, double residual, double weight) {
    heading_of(places.of_first) += weight;
    heading_of(places.of_second) += weight;
    heading_of(places.of_both) -= weight;
    pull(3 * places.first + 2, -weight * residual);
    pull(3 * places.second + 2, weight * residual);
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
  /// Moves of the nodes had the residuals of every cluster erred as much to either side: by what
  /// they say against each other, where the covariance tells what they leave open if the weights
  /// are right. The wild bootstrap (Liu 1988) of clusters (Cameron, Gelbach and Miller 2008) with
  /// Rademacher's signs, for one step from the solution.
  /// @param draw from 0, below the number of wild draws
  [[nodiscard]] std::vector<double> draw_wild(int draw) const;
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
  /// To the right side, a row of a node or, beyond these, of what is shared.
  void pull(std::size_t row, double by) {
    right_side_[row] += by;
    if (signs_.size() > 0) wild_right_.col(static_cast<Eigen::Index>(row)) += by * signs_;
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
  void eliminate_shared();
  /// A right side is turned into the step of the nodes, and of what is shared behind them.
  void solve_right(double* right) const;
  [[nodiscard]] std::vector<double> by_node(const double* by_position) const;

  static constexpr Eigen::Index kScale = 0;  ///< where the first direction would stand

  Supernodes supernodes_;
  BlockCholesky<3> matrix_;
  std::size_t nodes_;
  Eigen::Index shared_;
  std::vector<double> right_side_;  ///< of the nodes, and of what is shared behind them
  Eigen::VectorXd signs_;           ///< of the cluster that is added to, in each wild draw
  Eigen::MatrixXd wild_right_;      ///< of each draw, a column for each row of the right side
  Eigen::MatrixXd by_shared_;       ///< of the normal matrix, the columns of what is shared
  Eigen::MatrixXd node_by_shared_;  ///< how the nodes move with it, as last solved
  Eigen::MatrixXd shared_weight_;
  Eigen::MatrixXd shared_covariance_;  ///< as last solved
};

}  // namespace roomatlas
