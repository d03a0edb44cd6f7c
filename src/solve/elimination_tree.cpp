// SPDX-License-Identifier: GPL-3.0-or-later
#include "elimination_tree.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>

#include "index.hpp"

namespace roomatlas {
namespace {

using Indices = std::vector<std::int32_t>;

Indices minimum_degree(const Adjacency& graph) {
  const auto n = static_cast<std::int32_t>(graph.begin.size()) - 1;
  Eigen::SparseMatrix<char, Eigen::ColMajor, std::int32_t> pattern(n, n);
  pattern.resizeNonZeros(static_cast<Eigen::Index>(graph.neighbours.size()) + n);
  std::int32_t end = 0;
  for (std::int32_t i = 0; i < n; ++i) {  // the algorithm expects the diagonal
    pattern.outerIndexPtr()[i] = end;
    pattern.innerIndexPtr()[end++] = i;
    for (auto k = graph.begin[at(i)]; k < graph.begin[at(i) + 1]; ++k) {
      pattern.innerIndexPtr()[end++] = graph.neighbours[at(k)];
    }
  }
  pattern.outerIndexPtr()[n] = end;
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, std::int32_t> order;
  Eigen::internal::minimum_degree_ordering(pattern, order);
  return {order.indices().data(), order.indices().data() + n};
}

void set_positions(EliminationTree& tree) {
  tree.position.resize(tree.node.size());
  for (std::size_t k = 0; k < tree.node.size(); ++k) {
    tree.position[at(tree.node[k])] = static_cast<std::int32_t>(k);
  }
}

/// Liu's algorithm with path compression.
Indices parents(const Adjacency& graph, const EliminationTree& tree) {
  Indices parent(tree.node.size(), -1);
  Indices ancestor(tree.node.size(), -1);
  for (std::size_t row = 0; row < tree.node.size(); ++row) {
    const auto node = at(tree.node[row]);
    for (auto k = graph.begin[node]; k < graph.begin[node + 1]; ++k) {
      std::int32_t column = tree.position[at(graph.neighbours[at(k)])];
      while (column != -1 && column < static_cast<std::int32_t>(row)) {
        const std::int32_t next = ancestor[at(column)];
        ancestor[at(column)] = static_cast<std::int32_t>(row);
        if (next == -1) parent[at(column)] = static_cast<std::int32_t>(row);
        column = next;
      }
    }
  }
  return parent;
}

/// Rows below the diagonal of each column: each row's subtree is walked once.
Indices column_counts(const Adjacency& graph, const EliminationTree& tree) {
  Indices count(tree.node.size(), 0);
  Indices seen_by(tree.node.size(), -1);
  for (std::size_t row = 0; row < tree.node.size(); ++row) {
    const auto mark = static_cast<std::int32_t>(row);
    seen_by[row] = mark;
    const auto node = at(tree.node[row]);
    for (auto k = graph.begin[node]; k < graph.begin[node + 1]; ++k) {
      std::int32_t column = tree.position[at(graph.neighbours[at(k)])];
      if (column > mark) continue;
      for (; seen_by[at(column)] != mark; column = tree.parent[at(column)]) {
        seen_by[at(column)] = mark;
        ++count[at(column)];
      }
    }
  }
  return count;
}

/// Old position at each new one: children before parents, without gaps inside a subtree.
Indices postorder(const EliminationTree& tree) {
  const std::size_t n = tree.parent.size();
  // First child and next sibling. Children are put in front in ascending order of rows, so that the
  // one with most rows is met first here, and as the list is walked with a stack, comes last.
  Indices by_rows(n);
  {
    const std::int32_t most = n == 0 ? 0 : *std::ranges::max_element(tree.count);
    Indices begin(at(most) + 2, 0);
    for (const std::int32_t rows : tree.count) ++begin[at(rows) + 1];
    for (std::size_t rows = 1; rows < begin.size(); ++rows) begin[rows] += begin[rows - 1];
    for (std::size_t k = 0; k < n; ++k) {
      by_rows[at(begin[at(tree.count[k])]++)] = static_cast<std::int32_t>(k);
    }
  }
  Indices child(n, -1);
  Indices sibling(n, -1);
  Indices stack;
  for (auto k = by_rows.rbegin(); k != by_rows.rend(); ++k) {  // few rows end up in front
    const std::int32_t parent = tree.parent[at(*k)];
    if (parent == -1) continue;
    sibling[at(*k)] = child[at(parent)];
    child[at(parent)] = *k;
  }
  Indices order;
  order.reserve(n);
  for (std::size_t root = 0; root < n; ++root) {
    if (tree.parent[root] != -1) continue;
    stack.push_back(static_cast<std::int32_t>(root));
    while (!stack.empty()) {
      const std::int32_t top = stack.back();
      if (const std::int32_t next = child[at(top)]; next != -1) {
        child[at(top)] = sibling[at(next)];
        stack.push_back(next);
      } else {
        order.push_back(top);
        stack.pop_back();
      }
    }
  }
  return order;
}

void renumber(EliminationTree& tree, const Indices& order) {
  Indices renumbered(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    renumbered[at(order[k])] = static_cast<std::int32_t>(k);
  }
  const EliminationTree old = tree;
  for (std::size_t k = 0; k < order.size(); ++k) {
    tree.node[k] = old.node[at(order[k])];
    tree.count[k] = old.count[at(order[k])];
    const std::int32_t parent = old.parent[at(order[k])];
    tree.parent[k] = parent == -1 ? -1 : renumbered[at(parent)];
  }
  set_positions(tree);
}

}  // namespace

Adjacency adjacency_of(std::size_t node_count, const std::vector<NodePair>& pairs) {
  Indices end(node_count + 1, 0);
  for (const auto& [a, b] : pairs) {
    if (a == b) continue;
    ++end[at(a) + 1];
    ++end[at(b) + 1];
  }
  for (std::size_t i = 1; i <= node_count; ++i) end[i] += end[i - 1];
  Adjacency graph{end, Indices(at(end[node_count]))};
  Indices fill(end.begin(), end.end() - 1);
  for (const auto& [a, b] : pairs) {
    if (a == b) continue;
    graph.neighbours[at(fill[at(a)]++)] = b;
    graph.neighbours[at(fill[at(b)]++)] = a;
  }
  std::int32_t kept = 0;
  for (std::size_t i = 0; i < node_count; ++i) {
    const auto begin = graph.neighbours.begin() + end[i];
    const auto stop = graph.neighbours.begin() + end[i + 1];
    std::sort(begin, stop);
    graph.begin[i] = kept;
    const auto last = std::unique(begin, stop);
    kept = static_cast<std::int32_t>(std::copy(begin, last, graph.neighbours.begin() + kept) -
                                     graph.neighbours.begin());
  }
  graph.begin[node_count] = kept;
  graph.neighbours.resize(at(kept));
  return graph;
}

EliminationTree eliminate(const Adjacency& graph) {
  EliminationTree tree;
  tree.node = minimum_degree(graph);
  set_positions(tree);
  tree.parent = parents(graph, tree);
  tree.count = column_counts(graph, tree);
  renumber(tree, postorder(tree));
  return tree;
}

}  // namespace roomatlas
