// SPDX-License-Identifier: GPL-3.0-or-later
// A pose graph as the solver walks over it: nodes in the order of elimination, one fixed node a
// component, edges sorted by where they first act.
#pragma once

#include <cstdint>
#include <vector>

#include "roomatlas/solve/block_cholesky.hpp"
#include "roomatlas/solve/pose_graph.hpp"

namespace roomatlas {

/// Connected components, each with one node that does not move.
struct Components {
  std::vector<std::int32_t> component;  ///< of each node, numbered by the lowest id in each
  std::vector<std::int32_t> fixed;      ///< node of each component: the one with the lowest id
};

[[nodiscard]] Components components_of(const PoseGraph& graph);

/// An edge between two slots. `information` is that of the error in the frame of `from`, so that
/// nothing but the heading of `from` turns it: xx, xy, yy, xt, yt, tt.
struct SolverEdge {
  std::int32_t from = 0;
  std::int32_t to = 0;
  double x_m = 0.0;
  double y_m = 0.0;
  double theta_rad = 0.0;
  double information[6] = {};
  double cauchy_sigmas = 0.0;
};

/// A measured heading, quarter turns settled.
struct SolverHeading {
  std::int32_t slot = 0;
  double theta_rad = 0.0;
  double information = 0.0;  ///< 1/rad^2
  double cauchy_sigmas = 0.0;
};

/// The fixed node of a component that measured headings turn: a variable whose position is held.
struct Anchor {
  std::int32_t slot = 0;
  /// Of its position, 1/m^2. How stiff does not matter for the poses: nothing pulls at the place of
  /// a whole component. It is much stiffer than any edge so that covariances are right too.
  double information = 0.0;
};

struct SolverGraph {
  Components components;
  Supernodes supernodes;
  std::int32_t variable_count = 0;
  /// Of each node: its position of elimination, or at least variable_count where it is fixed.
  std::vector<std::int32_t> slot;
  std::vector<std::int32_t> roots;  ///< slot of each component's fixed node
  std::vector<SolverEdge> edges;
  std::vector<std::int32_t> edge_index;  ///< of each of `edges` in the pose graph
  std::vector<SolverHeading> headings;   ///< in the order of the pose graph
  std::vector<Anchor> anchors;           ///< of the components that have headings
};

[[nodiscard]] SolverGraph solver_graph_of(const PoseGraph& graph);

/// Where an edge acts in the matrix; -1 where a fixed node has no row.
struct EdgePlaces {
  std::int64_t between = -1;  ///< into the values; -1: one end does not move
  std::int32_t stride = 0;
};

/// Places of all blocks that the edges of a graph touch.
template <int Size>
struct MatrixPlaces {
  std::vector<BlockPlace> diagonal;  ///< by position
  std::vector<EdgePlaces> between;   ///< by edge of the SolverGraph
};

template <int Size>
[[nodiscard]] MatrixPlaces<Size> places_of(const SolverGraph& graph,
                                           const BlockCholesky<Size>& matrix) {
  MatrixPlaces<Size> places;
  places.diagonal.reserve(static_cast<std::size_t>(graph.variable_count));
  for (std::int32_t k = 0; k < graph.variable_count; ++k) {
    places.diagonal.push_back(matrix.place(k, k));
  }
  places.between.reserve(graph.edges.size());
  for (const SolverEdge& edge : graph.edges) {
    const std::int32_t row = edge.from > edge.to ? edge.from : edge.to;
    if (row >= graph.variable_count) {
      places.between.push_back({});
      continue;
    }
    const BlockPlace place = matrix.place(row, edge.from + edge.to - row);
    places.between.push_back({place.offset, place.stride});
  }
  return places;
}

}  // namespace roomatlas
