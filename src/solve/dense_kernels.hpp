// SPDX-License-Identifier: GPL-3.0-or-later
// Small dense steps of a Cholesky factorisation, column-major. Everything is inlined into its
// caller, so that it is compiled for the caller's instruction set.
#pragma once

#include <cmath>
#include <cstddef>

namespace roomatlas::dense {

#define ROOMATLAS_INLINE [[gnu::always_inline]] inline

/// Lower Cholesky factor of the leading Size x Size block, in place. False where a pivot is not
/// greater than `smallest`, which is 0 or a share of the diagonal before elimination.
/// @param inverse receives the inverses of the factor's diagonal
template <int Size>
ROOMATLAS_INLINE bool factor_block(double* block, std::ptrdiff_t stride, const double* smallest,
                                   double* inverse) {
  for (int j = 0; j < Size; ++j) {
    double pivot = block[j + j * stride];
    for (int k = 0; k < j; ++k) pivot -= block[j + k * stride] * block[j + k * stride];
    if (!(pivot > smallest[j])) return false;
    const double root = std::sqrt(pivot);
    block[j + j * stride] = root;
    inverse[j] = 1.0 / root;
    for (int i = j + 1; i < Size; ++i) {
      double value = block[i + j * stride];
      for (int k = 0; k < j; ++k) value -= block[i + k * stride] * block[j + k * stride];
      block[i + j * stride] = value * inverse[j];
    }
  }
  return true;
}

/// Width rows of the step below.
template <int Size, int Width>
ROOMATLAS_INLINE void solve_some_rows(const double* factor, const double* inverse, double* rows,
                                      std::ptrdiff_t stride) {
  using Lane [[gnu::vector_size(Width * sizeof(double)), gnu::aligned(8)]] = double;
  Lane column[Size];
  for (int j = 0; j < Size; ++j) {
    column[j] = *reinterpret_cast<const Lane*>(rows + j * stride);
    for (int k = 0; k < j; ++k) column[j] -= factor[j + k * stride] * column[k];
    column[j] *= inverse[j];
    *reinterpret_cast<Lane*>(rows + j * stride) = column[j];
  }
}

/// Rows below a factored block: rows := rows * inverse(factor)'.
template <int Size>
ROOMATLAS_INLINE void solve_rows(const double* factor, const double* inverse, double* rows,
                                 std::ptrdiff_t stride, std::ptrdiff_t count) {
  std::ptrdiff_t i = 0;
  for (; i + 4 <= count; i += 4) solve_some_rows<Size, 4>(factor, inverse, rows + i, stride);
  for (; i + 2 <= count; i += 2) solve_some_rows<Size, 2>(factor, inverse, rows + i, stride);
  for (; i < count; ++i) {
    for (int j = 0; j < Size; ++j) {
      double value = rows[i + j * stride];
      for (int k = 0; k < j; ++k) value -= factor[j + k * stride] * rows[i + k * stride];
      rows[i + j * stride] = value * inverse[j];
    }
  }
}

/// A column-major matrix that lies in another's memory.
template <typename Number>
struct MatrixAt {
  Number* first = nullptr;
  std::ptrdiff_t stride = 0;  ///< from one column to the next

  /// The matrix from a row and a column on.
  [[nodiscard]] ROOMATLAS_INLINE MatrixAt from(std::ptrdiff_t row, std::ptrdiff_t column) const {
    return {first + row + column * stride, stride};
  }
};
using Result = MatrixAt<double>;
using Factor = MatrixAt<const double>;

/// One tile of Lanes * Width rows: result -= left * right', over `depth` columns of both.
template <int Width, int Lanes, int Columns>
ROOMATLAS_INLINE void subtract_tile(Result result, Factor left, Factor right,
                                    std::ptrdiff_t depth) {
  using Lane [[gnu::vector_size(Width * sizeof(double)), gnu::aligned(8)]] = double;
  Lane sum[Columns][Lanes] = {};
  for (std::ptrdiff_t k = 0; k < depth; ++k) {
    for (int j = 0; j < Columns; ++j) {
      for (int i = 0; i < Lanes; ++i) {
        sum[j][i] +=
            *reinterpret_cast<const Lane*>(left.first + std::ptrdiff_t{i} * Width) * right.first[j];
      }
    }
    left.first += left.stride;
    right.first += right.stride;
  }
  for (int j = 0; j < Columns; ++j) {
    for (int i = 0; i < Lanes; ++i) {
      *reinterpret_cast<Lane*>(result.from(std::ptrdiff_t{i} * Width, j).first) -= sum[j][i];
    }
  }
}

/// Columns of one strip, from its first row down: result(i, j) -= sum_k left(i, k) right(j, k).
template <int Columns>
ROOMATLAS_INLINE void subtract_strip(Result result, Factor left, Factor right,
                                     std::ptrdiff_t row_count, std::ptrdiff_t depth) {
  std::ptrdiff_t i = 0;
  for (; i + 8 <= row_count; i += 8) {
    subtract_tile<4, 2, Columns>(result.from(i, 0), left.from(i, 0), right, depth);
  }
  if (i + 4 <= row_count) {
    subtract_tile<4, 1, Columns>(result.from(i, 0), left.from(i, 0), right, depth);
    i += 4;
  }
  if (i + 2 <= row_count) {
    subtract_tile<2, 1, Columns>(result.from(i, 0), left.from(i, 0), right, depth);
    i += 2;
  }
  if (i < row_count) {
    for (int j = 0; j < Columns; ++j) {
      double sum = 0.0;
      for (std::ptrdiff_t k = 0; k < depth; ++k)
        sum += left.first[i + k * left.stride] * right.first[j + k * right.stride];
      result.first[i + j * result.stride] -= sum;
    }
  }
}

/// The lower part of result := result - left * left', in strips of Size columns; `left` has
/// row_count rows and `depth` columns, `column_count` (a multiple of Size) says how many columns of
/// the result are wanted. A little above the diagonal is written too.
template <int Size>
ROOMATLAS_INLINE void subtract_product(Result result, Factor left, std::ptrdiff_t row_count,
                                       std::ptrdiff_t column_count, std::ptrdiff_t depth) {
  constexpr int kColumns = 2 * Size;  // of a strip: as many sums as registers hold
  std::ptrdiff_t j = 0;
  if (depth > Size) {  // else loading and storing outweighs what wider strips save
    for (; j + kColumns <= column_count; j += kColumns) {
      subtract_strip<kColumns>(result.from(j, j), left.from(j, 0), left.from(j, 0), row_count - j,
                               depth);
    }
  }
  for (; j < column_count; j += Size) {
    subtract_strip<Size>(result.from(j, j), left.from(j, 0), left.from(j, 0), row_count - j, depth);
  }
}

/// result := result - left * right', all of it.
/// @param right column_count rows
ROOMATLAS_INLINE void subtract_general(Result result, Factor left, Factor right,
                                       std::ptrdiff_t row_count, std::ptrdiff_t column_count,
                                       std::ptrdiff_t depth) {
  constexpr std::ptrdiff_t kDepth = 96;   // so many columns of `left` stay in the cache
  constexpr std::ptrdiff_t kColumns = 6;  // of a strip: as many sums as registers hold
  for (std::ptrdiff_t k = 0; k < depth; k += kDepth) {
    const std::ptrdiff_t now = k + kDepth < depth ? kDepth : depth - k;
    std::ptrdiff_t j = 0;
    for (; j + kColumns <= column_count; j += kColumns) {
      subtract_strip<kColumns>(result.from(0, j), left.from(0, k), right.from(j, k), row_count,
                               now);
    }
    for (; j < column_count; ++j) {
      subtract_strip<1>(result.from(0, j), left.from(0, k), right.from(j, k), row_count, now);
    }
  }
}

}  // namespace roomatlas::dense
