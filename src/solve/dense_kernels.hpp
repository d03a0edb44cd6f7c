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
  typedef double Lane __attribute__((vector_size(Width * sizeof(double)), aligned(8)));
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

/// One tile of Lanes * Width rows: result -= left * right', over `depth` columns of both.
template <int Width, int Lanes, int Columns>
ROOMATLAS_INLINE void subtract_tile(double* result, std::ptrdiff_t result_stride,
                                    const double* left, std::ptrdiff_t left_stride,
                                    const double* right, std::ptrdiff_t right_stride,
                                    std::ptrdiff_t depth) {
  typedef double Lane __attribute__((vector_size(Width * sizeof(double)), aligned(8)));
  Lane sum[Columns][Lanes] = {};
  for (std::ptrdiff_t k = 0; k < depth; ++k, left += left_stride, right += right_stride) {
    for (int j = 0; j < Columns; ++j) {
      for (int i = 0; i < Lanes; ++i) {
        sum[j][i] += *reinterpret_cast<const Lane*>(left + i * Width) * right[j];
      }
    }
  }
  for (int j = 0; j < Columns; ++j) {
    for (int i = 0; i < Lanes; ++i) {
      *reinterpret_cast<Lane*>(result + j * result_stride + i * Width) -= sum[j][i];
    }
  }
}

/// Columns of one strip, from its first row down: result(i, j) -= sum_k left(i, k) right(j, k).
template <int Columns>
ROOMATLAS_INLINE void subtract_strip(double* result, std::ptrdiff_t result_stride,
                                     const double* left, std::ptrdiff_t left_stride,
                                     const double* right, std::ptrdiff_t right_stride,
                                     std::ptrdiff_t row_count, std::ptrdiff_t depth) {
  std::ptrdiff_t i = 0;
  for (; i + 8 <= row_count; i += 8) {
    subtract_tile<4, 2, Columns>(result + i, result_stride, left + i, left_stride, right,
                                 right_stride, depth);
  }
  if (i + 4 <= row_count) {
    subtract_tile<4, 1, Columns>(result + i, result_stride, left + i, left_stride, right,
                                 right_stride, depth);
    i += 4;
  }
  if (i + 2 <= row_count) {
    subtract_tile<2, 1, Columns>(result + i, result_stride, left + i, left_stride, right,
                                 right_stride, depth);
    i += 2;
  }
  if (i < row_count) {
    for (int j = 0; j < Columns; ++j) {
      double sum = 0.0;
      for (std::ptrdiff_t k = 0; k < depth; ++k)
        sum += left[i + k * left_stride] * right[j + k * right_stride];
      result[i + j * result_stride] -= sum;
    }
  }
}

/// The lower part of result := result - left * left', in strips of Size columns; `left` has
/// row_count rows and `depth` columns, `column_count` (a multiple of Size) says how many columns of
/// the result are wanted. A little above the diagonal is written too.
template <int Size>
ROOMATLAS_INLINE void subtract_product(double* result, std::ptrdiff_t result_stride,
                                       const double* left, std::ptrdiff_t stride,
                                       std::ptrdiff_t row_count, std::ptrdiff_t column_count,
                                       std::ptrdiff_t depth) {
  constexpr int kColumns = 2 * Size;
  std::ptrdiff_t j = 0;
  if (depth > Size) {  // else loading and storing outweighs what wider strips save
    for (; j + kColumns <= column_count; j += kColumns) {
      subtract_strip<kColumns>(result + j + j * result_stride, result_stride, left + j, stride,
                               left + j, stride, row_count - j, depth);
    }
  }
  for (; j < column_count; j += Size) {
    subtract_strip<Size>(result + j + j * result_stride, result_stride, left + j, stride, left + j,
                         stride, row_count - j, depth);
  }
}

/// result := result - left * right', all of it.
/// @param right column_count rows
ROOMATLAS_INLINE void subtract_general(double* result, std::ptrdiff_t result_stride,
                                       const double* left, std::ptrdiff_t left_stride,
                                       const double* right, std::ptrdiff_t right_stride,
                                       std::ptrdiff_t row_count, std::ptrdiff_t column_count,
                                       std::ptrdiff_t depth) {
  constexpr std::ptrdiff_t kDepth = 96;  // so many columns of `left` stay in the cache
  constexpr std::ptrdiff_t kColumns = 6;
  for (std::ptrdiff_t k = 0; k < depth; k += kDepth) {
    const std::ptrdiff_t now = k + kDepth < depth ? kDepth : depth - k;
    const double* const l = left + k * left_stride;
    const double* const r = right + k * right_stride;
    std::ptrdiff_t j = 0;
    for (; j + kColumns <= column_count; j += kColumns) {
      subtract_strip<kColumns>(result + j * result_stride, result_stride, l, left_stride, r + j,
                               right_stride, row_count, now);
    }
    for (; j < column_count; ++j) {
      subtract_strip<1>(result + j * result_stride, result_stride, l, left_stride, r + j,
                        right_stride, row_count, now);
    }
  }
}

}  // namespace roomatlas::dense
