// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "roomatlas/solve/supernodes.hpp"

namespace roomatlas {

/// Where a block of the matrix is kept: its first element, and how far the next column is.
struct BlockPlace {
  std::int64_t offset = 0;
  std::int32_t stride = 0;
};

/// Sparse Cholesky factorisation of a symmetric positive definite matrix of Size x Size blocks,
/// multifrontal (Duff and Reid 1983; Liu 1992): each supernode's panel is dense, what it leaves to
/// later columns waits on a stack. The matrix is written where its factor will stand.
template <int Size>
class BlockCholesky {
 public:
  /// The matrix holds nothing of use before clear().
  explicit BlockCholesky(const Supernodes& nodes);

  /// Zeroes the matrix.
  void clear();
  /// The block at (row, column), row >= column, both positions; the pair must be known to the
  /// supernodes. Of a diagonal block only the lower part is read.
  [[nodiscard]] BlockPlace place(std::int32_t row, std::int32_t column) const;
  /// Column-major elements of all panels.
  [[nodiscard]] double* values() { return values_.get(); }
  [[nodiscard]] const double* values() const { return values_.get(); }
  [[nodiscard]] const Supernodes& nodes() const { return nodes_; }

  /// Replaces the matrix by its factor.
  /// @return -1, or the first position at which the matrix is not positive definite
  [[nodiscard]] std::int32_t factorize();

  /// Solves in place. @param x Size numbers a position
  void solve(double* x) const;
  /// The second half of that: with L the factor, x := inverse(L') x. Of independent numbers of
  /// variance 1 it makes numbers whose covariance is the inverse of the matrix.
  void solve_upper(double* x) const;

 private:
  const Supernodes& nodes_;
  std::size_t size_ = 0;  ///< numbers in `values_`
  std::unique_ptr<double[]> values_;
  std::unique_ptr<double[]> stack_;  ///< updates that wait for the parent's turn
  std::vector<double> diagonal_;
};

extern template class BlockCholesky<1>;
extern template class BlockCholesky<2>;
extern template class BlockCholesky<3>;
extern template class BlockCholesky<4>;

}  // namespace roomatlas
