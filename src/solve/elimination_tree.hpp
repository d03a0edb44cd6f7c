// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "roomatlas/solve/supernodes.hpp"

namespace roomatlas {

/// Neighbours of each node, both ways, each once, ascending.
struct Adjacency {
  std::vector<std::int32_t> begin;  ///< into `neighbours`, and the end
  std::vector<std::int32_t> neighbours;
};

[[nodiscard]] Adjacency adjacency_of(std::size_t node_count, const std::vector<NodePair>& pairs);

/// An order of elimination, and what depends on what in it. All by position.
struct EliminationTree {
  std::vector<std::int32_t> node;      ///< at each position
  std::vector<std::int32_t> position;  ///< of each node
  std::vector<std::int32_t> parent;    ///< first row below the diagonal, or -1
  std::vector<std::int32_t> count;     ///< rows below the diagonal
};

/// Minimum degree, then postordered, the child with most rows last.
[[nodiscard]] EliminationTree eliminate(const Adjacency& graph);

}  // namespace roomatlas
