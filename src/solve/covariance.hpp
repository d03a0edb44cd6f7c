// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "least_squares.hpp"

namespace roomatlas {

/// The blocks of an inverse at the places where the Cholesky factor has entries (Takahashi et al.
/// 1973; Erisman and Tinney 1975), kept like the factor itself.
class SelectedInverse {
 public:
  explicit SelectedInverse(const BlockCholesky<3>& factor);

  /// Covariance of two positions that the supernodes know as a pair; zero where one is fixed
  /// (at or beyond the number of positions).
  [[nodiscard]] Eigen::Matrix3d block(std::int32_t row, std::int32_t column) const;
  /// Of the relative pose of an edge's ends, in the frame of `from`, at a state.
  [[nodiscard]] Eigen::Matrix3d relative(const SlotPoses& state, std::int32_t from,
                                         std::int32_t to) const;

 private:
  void gather(std::size_t s);
  void invert(const BlockCholesky<3>& factor, std::size_t s);

  const Supernodes& nodes_;
  std::vector<double> values_;
  std::vector<double> front_;  ///< the inverse at a supernode's columns and rows, while it is found
};

[[nodiscard]] PoseCovariance covariance_of(const PoseGraph& poses, LeastSquares& squares,
                                           const SlotPoses& state, std::span<const double> weights);

}  // namespace roomatlas
