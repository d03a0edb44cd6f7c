// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/solve/block_cholesky.hpp"

#include <algorithm>
#include <cstring>

#include "dense_kernels.hpp"
#include "dense_product.hpp"
#include "index.hpp"

namespace roomatlas {
namespace {

/// Pivots below this share of the diagonal are rounding: the matrix is singular.
constexpr double kSmallestShare = 1e-14;

/// Doubles that the stack of updates needs at most.
template <int Size>
std::size_t stack_need(const Supernodes& nodes) {
  const auto update = [&](std::size_t s) {
    const auto side = static_cast<std::size_t>(nodes.row_count(s)) * Size;
    return side * side;
  };
  std::vector<std::size_t> child_sum(nodes.size(), 0);
  std::size_t waiting = 0;
  std::size_t most = 0;
  for (std::size_t s = 0; s < nodes.size(); ++s) {
    most = std::max(most, waiting + update(s));
    waiting = waiting - child_sum[s] + update(s);
    if (nodes.parent[s] != -1) child_sum[at(nodes.parent[s])] += update(s);
  }
  return most;
}

struct Front {
  double* panel = nullptr;   ///< columns of the supernode, rows of the front
  double* update = nullptr;  ///< lower part of what is left to later columns
  std::ptrdiff_t width = 0;  ///< of the supernode, in numbers
  std::ptrdiff_t rows = 0;   ///< below it, in numbers
};

/// Rows of a child that stand together in the parent's front too.
struct Run {
  std::ptrdiff_t in_child = 0;
  std::ptrdiff_t in_front = 0;
  std::ptrdiff_t count = 0;
};

template <int Size>
ROOMATLAS_INLINE std::ptrdiff_t find_runs(std::ptrdiff_t child_rows,
                                          const std::int32_t* row_in_front, Run* runs) {
  std::ptrdiff_t count = 0;
  for (std::ptrdiff_t r = 0; r < child_rows; ++r) {
    if (r > 0 && row_in_front[r] == row_in_front[r - 1] + 1) {
      runs[count - 1].count += Size;
    } else {
      runs[count++] = {r * Size, std::ptrdiff_t{row_in_front[r]} * Size, Size};
    }
  }
  return count;
}

/// Adds a child's update where its rows stand in this front.
template <int Size>
ROOMATLAS_INLINE void add_child(const Front& front, const double* child, std::ptrdiff_t child_rows,
                                const std::int32_t* row_in_front, Run* runs) {
  const std::ptrdiff_t panel_stride = front.width + front.rows;
  const std::ptrdiff_t child_stride = child_rows * Size;
  const std::ptrdiff_t run_count = find_runs<Size>(child_rows, row_in_front, runs);
  for (std::ptrdiff_t first = 0, c = 0; c < child_rows; ++c) {
    const std::ptrdiff_t column = std::ptrdiff_t{row_in_front[c]} * Size;
    const bool in_panel = column < front.width;
    const std::ptrdiff_t stride = in_panel ? panel_stride : front.rows;
    double* const target = in_panel ? front.panel + column * stride
                                    : front.update + (column - front.width) * stride - front.width;
    const double* const source = child + c * Size * child_stride;
    while (runs[first].in_child + runs[first].count <= c * Size) ++first;
    const std::ptrdiff_t above = c * Size - runs[first].in_child;
    for (std::ptrdiff_t j = 0; j < Size; ++j) {
      double* to = target + runs[first].in_front + above + j * stride;
      const double* from = source + c * Size + j * child_stride;
      for (std::ptrdiff_t i = 0; i < runs[first].count - above; ++i) to[i] += from[i];
      for (std::ptrdiff_t k = first + 1; k < run_count; ++k) {
        to = target + runs[k].in_front + j * stride;
        from = source + runs[k].in_child + j * child_stride;
        for (std::ptrdiff_t i = 0; i < runs[k].count; i += Size) {
          for (int u = 0; u < Size; ++u) to[i + u] += from[i + u];
        }
      }
    }
  }
}

/// Eliminates the panel's columns: each chunk of columns left-looking, the rest of the panel after
/// each chunk. @return the column that fails, or -1
template <int Size>
ROOMATLAS_INLINE std::ptrdiff_t eliminate_panel(const Front& front, const double* smallest) {
  constexpr std::ptrdiff_t kChunk =
      std::ptrdiff_t{8} * Size;  // fewer: small products; more: column by column
  const std::ptrdiff_t stride = front.width + front.rows;
  for (std::ptrdiff_t begin = 0; begin < front.width; begin += kChunk) {
    const std::ptrdiff_t end = std::min(begin + kChunk, front.width);
    for (std::ptrdiff_t k = begin; k < end; k += Size) {
      double inverse[Size];
      double* const block = front.panel + k + k * stride;
      const double* const before = front.panel + k + begin * stride;
      if (k > begin) {
        dense::subtract_strip<Size>({block, stride}, {before, stride}, {before, stride}, stride - k,
                                    k - begin);
      }
      if (!dense::factor_block<Size>(block, stride, smallest + k, inverse)) return k;
      dense::solve_rows<Size>(block, inverse, block + Size, stride, stride - k - Size);
    }
    if (end < front.width) {
      dense::subtract_product<Size>({front.panel + end + end * stride, stride},
                                    {front.panel + end + begin * stride, stride}, stride - end,
                                    front.width - end, end - begin);
    }
  }
  if (front.rows > 0) {
    dense::subtract_product<Size>({front.update, front.rows}, {front.panel + front.width, stride},
                                  front.rows, front.rows, front.width);
  }
  return -1;
}

template <int Size>
ROOMATLAS_INLINE std::int32_t eliminate_all(const Supernodes& nodes, double* values, double* stack,
                                            const double* smallest) {
  struct Waiting {
    std::size_t supernode;
    std::ptrdiff_t begin;
  };
  std::vector<Waiting> waiting;
  std::vector<Run> runs(at(nodes.most_rows) + 1);
  std::ptrdiff_t top = 0;
  for (std::size_t s = 0; s < nodes.size(); ++s) {
    Front front;
    front.panel = values + nodes.panel_begin[s] * Size * Size;
    front.width = std::ptrdiff_t{nodes.width(s)} * Size;
    front.rows = std::ptrdiff_t{nodes.row_count(s)} * Size;
    front.update = stack + top;
    const std::ptrdiff_t update_size = front.rows * front.rows;
    std::fill_n(front.update, update_size, 0.0);
    std::ptrdiff_t base = top;
    while (!waiting.empty() && nodes.parent[waiting.back().supernode] == static_cast<int>(s)) {
      const Waiting child = waiting.back();
      waiting.pop_back();
      base = child.begin;
      add_child<Size>(front, stack + child.begin, nodes.row_count(child.supernode),
                      nodes.row_in_parent.data() + nodes.rows_begin[child.supernode], runs.data());
    }
    const std::ptrdiff_t failed =
        eliminate_panel<Size>(front, smallest + std::ptrdiff_t{nodes.first[s]} * Size);
    if (failed != -1) return nodes.first[s] + static_cast<std::int32_t>(failed / Size);
    if (update_size == 0) {
      top = base;
      continue;
    }
    if (base != top) {
      std::memmove(stack + base, front.update, at(update_size) * sizeof(double));
    }
    waiting.push_back({s, base});
    top = base + update_size;
  }
  return -1;
}

#if defined(__x86_64__)
template <int Size>
[[gnu::target("avx2,fma")]] std::int32_t eliminate_with_avx2(const Supernodes& nodes,
                                                             double* values, double* stack,
                                                             const double* smallest) {
  return eliminate_all<Size>(nodes, values, stack, smallest);
}
#endif

/// x := inverse(L) x. A supernode's rows are gathered, so that its columns run straight through.
template <int Size>
ROOMATLAS_INLINE void solve_forward(const Supernodes& nodes, const double* values, double* x,
                                    double* below) {
  for (std::size_t s = 0; s < nodes.size(); ++s) {
    const std::ptrdiff_t width = std::ptrdiff_t{nodes.width(s)} * Size;
    const std::ptrdiff_t rows = nodes.row_count(s);
    const std::ptrdiff_t stride = width + rows * Size;
    const std::int32_t* const row = nodes.rows.data() + nodes.rows_begin[s];
    const double* column = values + nodes.panel_begin[s] * Size * Size;
    double* const own = x + std::ptrdiff_t{nodes.first[s]} * Size;
    for (std::ptrdiff_t i = 0; i < rows * Size; ++i) below[i] = 0.0;
    for (std::ptrdiff_t j = 0; j < width; ++j, column += stride) {
      const double value = own[j] / column[j];
      own[j] = value;
      for (std::ptrdiff_t i = j + 1; i < width; ++i) own[i] -= column[i] * value;
      const double* const entries = column + width;
      for (std::ptrdiff_t i = 0; i < rows * Size; ++i) below[i] += entries[i] * value;
    }
    for (std::ptrdiff_t r = 0; r < rows; ++r) {
      for (int i = 0; i < Size; ++i) x[std::ptrdiff_t{row[r]} * Size + i] -= below[r * Size + i];
    }
  }
}

/// x := inverse(L') x.
template <int Size>
ROOMATLAS_INLINE void solve_backward(const Supernodes& nodes, const double* values, double* x,
                                     double* below) {
  for (std::size_t s = nodes.size(); s-- > 0;) {
    const std::ptrdiff_t width = std::ptrdiff_t{nodes.width(s)} * Size;
    const std::ptrdiff_t rows = nodes.row_count(s);
    const std::ptrdiff_t stride = width + rows * Size;
    const std::int32_t* const row = nodes.rows.data() + nodes.rows_begin[s];
    const double* const panel = values + nodes.panel_begin[s] * Size * Size;
    double* const own = x + std::ptrdiff_t{nodes.first[s]} * Size;
    for (std::ptrdiff_t r = 0; r < rows; ++r) {
      for (int i = 0; i < Size; ++i) below[r * Size + i] = x[std::ptrdiff_t{row[r]} * Size + i];
    }
    for (std::ptrdiff_t j = width; j-- > 0;) {
      const double* const column = panel + j * stride;
      double sum[Size] = {};
      for (std::ptrdiff_t i = 0; i < rows * Size; i += Size) {
        for (int u = 0; u < Size; ++u) sum[u] += column[width + i + u] * below[i + u];
      }
      double value = own[j];
      for (int u = 0; u < Size; ++u) value -= sum[u];
      for (std::ptrdiff_t i = j + 1; i < width; ++i) value -= column[i] * own[i];
      own[j] = value / column[j];
    }
  }
}

template <int Size>
ROOMATLAS_INLINE void solve_both(const Supernodes& nodes, const double* values, double* x) {
  std::vector<double> below(at(nodes.most_rows) * Size);
  solve_forward<Size>(nodes, values, x, below.data());
  solve_backward<Size>(nodes, values, x, below.data());
}

template <int Size>
ROOMATLAS_INLINE void solve_last(const Supernodes& nodes, const double* values, double* x) {
  std::vector<double> below(at(nodes.most_rows) * Size);
  solve_backward<Size>(nodes, values, x, below.data());
}

#if defined(__x86_64__)
template <int Size>
[[gnu::target("avx2,fma")]] void solve_last_with_avx2(const Supernodes& nodes, const double* values,
                                                      double* x) {
  solve_last<Size>(nodes, values, x);
}

template <int Size>
[[gnu::target("avx2,fma")]] void solve_with_avx2(const Supernodes& nodes, const double* values,
                                                 double* x) {
  solve_both<Size>(nodes, values, x);
}
#endif

}  // namespace

template <int Size>
BlockCholesky<Size>::BlockCholesky(const Supernodes& nodes)
    : nodes_(nodes),
      size_(at(nodes.panel_begin.back() * Size * Size)),
      values_(std::make_unique_for_overwrite<double[]>(size_)),
      stack_(std::make_unique_for_overwrite<double[]>(stack_need<Size>(nodes))),
      diagonal_(nodes.position.size() * Size) {}

template <int Size>
void BlockCholesky<Size>::clear() {
  std::fill_n(values_.get(), size_, 0.0);
}

template <int Size>
BlockPlace BlockCholesky<Size>::place(std::int32_t row, std::int32_t column) const {
  const auto s = at(nodes_.owner[at(column)]);
  const std::int32_t stride = (nodes_.width(s) + nodes_.row_count(s)) * Size;
  const std::int64_t first = nodes_.panel_begin[s] * Size * Size;
  const std::int64_t j = std::int64_t{column - nodes_.first[s]} * Size;
  return {first + j * stride + std::ptrdiff_t{nodes_.row_in_front(s, row)} * Size, stride};
}

template <int Size>
std::int32_t BlockCholesky<Size>::factorize() {
  for (std::size_t s = 0; s < nodes_.size(); ++s) {
    const std::ptrdiff_t width = std::ptrdiff_t{nodes_.width(s)} * Size;
    const std::ptrdiff_t stride = width + std::ptrdiff_t{nodes_.row_count(s)} * Size;
    const double* const panel = values_.get() + nodes_.panel_begin[s] * Size * Size;
    for (std::ptrdiff_t j = 0; j < width; ++j) {
      diagonal_[at(nodes_.first[s]) * Size + at(j)] = kSmallestShare * panel[j + j * stride];
    }
  }
#if defined(__x86_64__)
  if (has_avx2()) {
    return eliminate_with_avx2<Size>(nodes_, values_.get(), stack_.get(), diagonal_.data());
  }
#endif
  return eliminate_all<Size>(nodes_, values_.get(), stack_.get(), diagonal_.data());
}

template <int Size>
void BlockCholesky<Size>::solve(double* x) const {
#if defined(__x86_64__)
  if (has_avx2()) return solve_with_avx2<Size>(nodes_, values_.get(), x);
#endif
  solve_both<Size>(nodes_, values_.get(), x);
}

template <int Size>
void BlockCholesky<Size>::solve_upper(double* x) const {
#if defined(__x86_64__)
  if (has_avx2()) return solve_last_with_avx2<Size>(nodes_, values_.get(), x);
#endif
  solve_last<Size>(nodes_, values_.get(), x);
}

template class BlockCholesky<1>;
template class BlockCholesky<2>;
template class BlockCholesky<3>;
template class BlockCholesky<4>;

}  // namespace roomatlas
