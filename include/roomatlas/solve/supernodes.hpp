// SPDX-License-Identifier: GPL-3.0-or-later
// The structure of a sparse Cholesky factor of which one entry is a small dense block: one block
// a node of the pose graph. Found once, used by every factorisation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace roomatlas {

/// Two nodes that share an entry of the matrix.
using NodePair = std::pair<std::int32_t, std::int32_t>;

/// Columns with (nearly) the same rows stand together as one dense panel, a supernode. Columns are
/// numbered in the order of elimination: "position".
struct Supernodes {
  std::vector<std::int32_t> position;    ///< of each node
  std::vector<std::int32_t> owner;       ///< supernode of each position
  std::vector<std::int32_t> first;       ///< first position of each supernode, and the end
  std::vector<std::int32_t> parent;      ///< supernode that eliminates its first row, or -1
  std::vector<std::int64_t> rows_begin;  ///< into `rows`, and the end
  std::vector<std::int32_t> rows;        ///< positions below each supernode's own, ascending
  /// Where each of `rows` stands in the parent's front (its columns, then its rows).
  std::vector<std::int32_t> row_in_parent;
  std::vector<std::int64_t> panel_begin;  ///< in blocks, and the end
  std::int32_t most_rows = 0;             ///< of any supernode

  [[nodiscard]] std::size_t size() const { return parent.size(); }
  [[nodiscard]] std::int32_t width(std::size_t s) const { return first[s + 1] - first[s]; }
  [[nodiscard]] std::int32_t row_count(std::size_t s) const {
    return static_cast<std::int32_t>(rows_begin[s + 1] - rows_begin[s]);
  }
  /// Where position `row` stands in the front of supernode `s`, which must hold it.
  [[nodiscard]] std::int32_t row_in_front(std::size_t s, std::int32_t row) const;
};

/// Orders by approximate minimum degree (Amestoy, Davis, Duff 1996) on the graph of blocks.
/// @param pairs without repetition of what order the two stand in is needed; a pair may repeat,
///   and a node with itself is passed over
[[nodiscard]] Supernodes find_supernodes(std::size_t node_count,
                                         const std::vector<NodePair>& pairs);

}  // namespace roomatlas
