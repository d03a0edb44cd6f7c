// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace roomatlas {

/// Whether this processor has AVX2 and fused multiplication and addition.
[[nodiscard]] bool has_avx2();

/// A column-major matrix that lies in another's memory.
struct DenseView {
  double* data = nullptr;
  std::ptrdiff_t stride = 0;  ///< from one column to the next
};

/// result := result - left * right', for a result of `rows` x `columns` and factors of `depth`
/// columns. Compiled for AVX2 and for any processor, chosen at run time.
void subtract_product(DenseView result, DenseView left, DenseView right, std::ptrdiff_t rows,
                      std::ptrdiff_t columns, std::ptrdiff_t depth);

}  // namespace roomatlas
