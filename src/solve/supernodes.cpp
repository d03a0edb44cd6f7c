// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/solve/supernodes.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "elimination_tree.hpp"

#include "index.hpp"

namespace roomatlas {
namespace {

using Indices = std::vector<std::int32_t>;

/// How many zeros a panel may store: narrow ones cost more to handle than their zeros do.
struct MostZeros {
  std::int32_t up_to_width;
  double share;  ///< of the panel's blocks. More zeros are more to multiply, fewer more panels
};
/// A panel pays where one of these lets it.
constexpr std::array kMostZeros = {MostZeros{2, 0.25}, MostZeros{6, 0.2}, MostZeros{16, 0.1},
                                   MostZeros{std::numeric_limits<std::int32_t>::max(), 0.03}};

/// Whether a panel of this width pays although `zeros` of its `blocks` are zero.
bool pays(std::int32_t width, std::int64_t zeros, std::int64_t blocks) {
  if (zeros == 0) return true;
  const double share = static_cast<double>(zeros) / static_cast<double>(blocks);
  return std::ranges::any_of(kMostZeros, [&](const MostZeros& most) {
    return width <= most.up_to_width && share < most.share;
  });
}

/// First position of each supernode. A chain of columns is cut where joining it would store too
/// many zeros. Only a parent's last child stands beside it, so only that one can join.
Indices first_positions(const EliminationTree& tree) {
  struct Open {
    std::int32_t first = 0;
    std::int64_t entries = 0;  ///< blocks that are not zero by structure
  };
  const auto n = static_cast<std::int32_t>(tree.parent.size());
  Indices first;
  Open open;
  for (std::int32_t k = 0; k < n; ++k) {
    const std::int32_t rows = tree.count[at(k)];
    if (k > 0 && tree.parent[at(k) - 1] == k) {
      const std::int32_t width = k - open.first + 1;
      const std::int64_t blocks =
          std::int64_t{width} * (width + 1) / 2 + std::int64_t{width} * rows;
      const std::int64_t entries = open.entries + rows + 1;
      if (pays(width, blocks - entries, blocks)) {
        open.entries = entries;
        continue;
      }
    }
    first.push_back(k);
    open = {k, rows + 1};
  }
  first.push_back(n);
  return first;
}

/// Rows below each supernode: those of its own entries and those of its children.
class RowFinder {
 public:
  RowFinder(const Adjacency& graph, const EliminationTree& tree, Supernodes& nodes)
      : graph_(graph), tree_(tree), nodes_(nodes), seen_by_(tree.parent.size(), -1) {}

  void find_all() {
    const std::size_t count = nodes_.first.size() - 1;
    Indices child(count, -1);
    Indices sibling(count, -1);
    nodes_.parent.assign(count, -1);
    nodes_.rows_begin.push_back(0);
    for (std::size_t s = 0; s < count; ++s) {
      mark_ = static_cast<std::int32_t>(s);
      end_ = nodes_.first[s + 1];
      for (std::int32_t k = nodes_.first[s]; k < end_; ++k) add_entries(at(tree_.node[at(k)]));
      for (std::int32_t c = child[s]; c != -1; c = sibling[at(c)]) {
        for (auto r = nodes_.rows_begin[at(c)]; r < nodes_.rows_begin[at(c) + 1]; ++r) {
          add(nodes_.rows[at(r)]);
        }
      }
      std::sort(nodes_.rows.begin() + nodes_.rows_begin.back(), nodes_.rows.end());
      if (std::ssize(nodes_.rows) > nodes_.rows_begin.back()) {
        const std::int32_t parent = nodes_.owner[at(nodes_.rows[at(nodes_.rows_begin.back())])];
        nodes_.parent[s] = parent;
        sibling[s] = child[at(parent)];
        child[at(parent)] = static_cast<std::int32_t>(s);
      }
      nodes_.rows_begin.push_back(std::ssize(nodes_.rows));
    }
  }

 private:
  void add_entries(std::size_t node) {
    for (auto k = graph_.begin[node]; k < graph_.begin[node + 1]; ++k) {
      add(tree_.position[at(graph_.neighbours[at(k)])]);
    }
  }
  void add(std::int32_t row) {
    if (row < end_ || seen_by_[at(row)] == mark_) return;
    seen_by_[at(row)] = mark_;
    nodes_.rows.push_back(row);
  }

  const Adjacency& graph_;
  const EliminationTree& tree_;
  Supernodes& nodes_;
  Indices seen_by_;
  std::int32_t mark_ = 0;
  std::int32_t end_ = 0;
};

void place_in_parents(Supernodes& nodes) {
  nodes.row_in_parent.resize(nodes.rows.size());
  for (std::size_t s = 0; s < nodes.size(); ++s) {
    if (nodes.parent[s] == -1) continue;
    const auto p = at(nodes.parent[s]);
    auto in_parent = nodes.rows_begin[p];
    for (auto r = nodes.rows_begin[s]; r < nodes.rows_begin[s + 1]; ++r) {
      const std::int32_t row = nodes.rows[at(r)];
      if (row < nodes.first[p + 1]) {
        nodes.row_in_parent[at(r)] = row - nodes.first[p];
        continue;
      }
      while (nodes.rows[at(in_parent)] != row) ++in_parent;
      nodes.row_in_parent[at(r)] =
          nodes.width(p) + static_cast<std::int32_t>(in_parent - nodes.rows_begin[p]);
    }
  }
}

}  // namespace

std::int32_t Supernodes::row_in_front(std::size_t s, std::int32_t row) const {
  if (row < first[s + 1]) return row - first[s];
  const auto begin = rows.begin() + rows_begin[s];
  const auto found = std::lower_bound(begin, rows.begin() + rows_begin[s + 1], row);
  return width(s) + static_cast<std::int32_t>(found - begin);
}

Supernodes find_supernodes(std::size_t node_count, const std::vector<NodePair>& pairs) {
  const Adjacency graph = adjacency_of(node_count, pairs);
  EliminationTree tree = eliminate(graph);
  Supernodes nodes;
  nodes.first = first_positions(tree);
  nodes.owner.resize(node_count);
  for (std::size_t s = 0; s + 1 < nodes.first.size(); ++s) {
    std::fill(nodes.owner.begin() + nodes.first[s], nodes.owner.begin() + nodes.first[s + 1],
              static_cast<std::int32_t>(s));
  }
  RowFinder(graph, tree, nodes).find_all();
  place_in_parents(nodes);
  nodes.panel_begin.push_back(0);
  for (std::size_t s = 0; s < nodes.size(); ++s) {
    const std::int64_t width = nodes.width(s);
    nodes.most_rows = std::max(nodes.most_rows, nodes.row_count(s));
    nodes.panel_begin.push_back(nodes.panel_begin.back() + width * (width + nodes.row_count(s)));
  }
  nodes.position = std::move(tree.position);
  return nodes;
}

}  // namespace roomatlas
