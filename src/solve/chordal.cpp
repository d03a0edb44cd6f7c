// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "chordal.hpp"

#include "index.hpp"

namespace roomatlas {
namespace {

/// Fills the equations of the complex numbers, each as two reals.
void fill(const SolverGraph& graph, std::span<const double> weights, BlockCholesky<2>& matrix,
          std::vector<double>& z) {
  const std::int32_t variables = graph.variable_count;
  double* const values = matrix.values();
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const SolverEdge& edge = graph.edges[e];
    const double w = (weights.empty() ? 1.0 : weights[e]) * edge.information[5];
    if (w == 0.0) continue;
    const double c = w * std::cos(edge.theta_rad);
    const double s = w * std::sin(edge.theta_rad);
    for (const std::int32_t slot : {edge.from, edge.to}) {
      if (slot >= variables) continue;
      const BlockPlace place = matrix.place(slot, slot);
      values[place.offset] += w;
      values[place.offset + place.stride + 1] += w;
    }
    if (edge.from >= variables) {  // the fixed node's number is 1
      if (edge.to < variables) {
        z[at(edge.to) * 2] += c;
        z[at(edge.to) * 2 + 1] += s;
      }
    } else if (edge.to >= variables) {
      z[at(edge.from) * 2] += c;
      z[at(edge.from) * 2 + 1] -= s;
    } else {
      const bool from_is_row = edge.from > edge.to;
      const BlockPlace place =
          from_is_row ? matrix.place(edge.from, edge.to) : matrix.place(edge.to, edge.from);
      const double turn = from_is_row ? -s : s;
      double* const block = values + place.offset;
      block[0] -= c;
      block[1] -= turn;
      block[place.stride] += turn;
      block[place.stride + 1] -= c;
    }
  }
}

/// The number of a node is said to be exp(i theta).
void add_unary(std::int32_t slot, double theta_rad, double weight, BlockCholesky<2>& matrix,
               std::vector<double>& z) {
  const BlockPlace place = matrix.place(slot, slot);
  matrix.values()[place.offset] += weight;
  matrix.values()[place.offset + place.stride + 1] += weight;
  z[at(slot) * 2] += weight * std::cos(theta_rad);
  z[at(slot) * 2 + 1] += weight * std::sin(theta_rad);
}

}  // namespace

SlotPoses chordal_headings(const SolverGraph& graph, std::span<const double> weights,
                           bool headings) {
  BlockCholesky<2> matrix(graph.supernodes);
  matrix.clear();
  std::vector<double> z(at(graph.variable_count) * 2, 0.0);
  fill(graph, weights, matrix, z);
  if (headings) {
    for (const SolverHeading& heading : graph.headings) {
      add_unary(heading.slot, heading.theta_rad, heading.information, matrix, z);
    }
  } else {
    for (const Anchor& anchor : graph.anchors) add_unary(anchor.slot, 0.0, 1.0, matrix, z);
  }
  if (matrix.factorize() != -1) return {};
  matrix.solve(z.data());
  SlotPoses state(graph.slot.size() * 3, 0.0);
  for (std::size_t k = 0; k < at(graph.variable_count); ++k) {
    state[k * 3 + 2] = std::atan2(z[k * 2 + 1], z[k * 2]);
  }
  return state;
}

}  // namespace roomatlas
