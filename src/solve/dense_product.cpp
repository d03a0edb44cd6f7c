// SPDX-License-Identifier: GPL-3.0-or-later
#include "dense_product.hpp"

#include "dense_kernels.hpp"

namespace roomatlas {
namespace {

ROOMATLAS_INLINE void subtract(const DenseView& result, const DenseView& left,
                               const DenseView& right, std::ptrdiff_t rows, std::ptrdiff_t columns,
                               std::ptrdiff_t depth) {
  dense::subtract_general({result.data, result.stride}, {left.data, left.stride},
                          {right.data, right.stride}, rows, columns, depth);
}

#if defined(__x86_64__)
[[gnu::target("avx2,fma")]] void subtract_with_avx2(const DenseView& result, const DenseView& left,
                                                    const DenseView& right, std::ptrdiff_t rows,
                                                    std::ptrdiff_t columns, std::ptrdiff_t depth) {
  subtract(result, left, right, rows, columns, depth);
}
#endif

}  // namespace

bool has_avx2() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
#else
  return false;
#endif
}

void subtract_product(DenseView result, DenseView left, DenseView right, std::ptrdiff_t rows,
                      std::ptrdiff_t columns, std::ptrdiff_t depth) {
#if defined(__x86_64__)
  if (has_avx2()) return subtract_with_avx2(result, left, right, rows, columns, depth);
#endif
  subtract(result, left, right, rows, columns, depth);
}

}  // namespace roomatlas
