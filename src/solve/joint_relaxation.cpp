// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint_relaxation.hpp"

#include <cmath>
#include <complex>

#include "index.hpp"

namespace roomatlas {
namespace {

using Complex = std::complex<double>;

/// The equations of the unknowns t and z of each node, as four real numbers.
struct Equations {
  BlockCholesky<4> matrix;
  std::vector<double> right_side;

  /// Unknown 0 is t, 1 is z. Of the diagonal's blocks the upper part is never read.
  void add(const BlockPlace& place, int row, int column, Complex value) {
    const std::ptrdiff_t from_column = std::ptrdiff_t{2} * column * place.stride;
    double* const block = matrix.values() + place.offset + from_column + std::ptrdiff_t{2} * row;
    block[0] += value.real();
    block[1] += value.imag();
    block[place.stride] -= value.imag();
    block[place.stride + 1] += value.real();
  }
  void add_right(std::int32_t slot, int row, Complex value) {
    right_side[at(slot) * 4 + at(std::int64_t{2} * row)] += value.real();
    right_side[at(slot) * 4 + at(std::int64_t{2} * row + 1)] += value.imag();
  }
};

struct Weights {
  double position = 0.0;
  double heading = 0.0;
};

void add_edge(const SolverEdge& edge, const Weights& w, std::int32_t variables, Equations& to) {
  const Complex step(edge.x_m, edge.y_m);
  const Complex turn = std::polar(1.0, edge.theta_rad);
  const bool from_moves = edge.from < variables;
  const bool to_moves = edge.to < variables;
  if (from_moves) {
    const BlockPlace place = to.matrix.place(edge.from, edge.from);
    to.add(place, 0, 0, w.position);
    to.add(place, 1, 0, w.position * std::conj(step));
    to.add(place, 1, 1, w.position * std::norm(step) + w.heading);
  }
  if (to_moves) {
    const BlockPlace place = to.matrix.place(edge.to, edge.to);
    to.add(place, 0, 0, w.position);
    to.add(place, 1, 1, w.heading);
  }
  if (!from_moves && to_moves) {  // the fixed node has t = 0, z = 1
    to.add_right(edge.to, 0, w.position * step);
    to.add_right(edge.to, 1, w.heading * turn);
  } else if (from_moves && !to_moves) {
    to.add_right(edge.from, 1, w.heading * std::conj(turn));
  } else if (from_moves && edge.to > edge.from) {
    const BlockPlace place = to.matrix.place(edge.to, edge.from);
    to.add(place, 0, 0, -w.position);
    to.add(place, 0, 1, -w.position * step);
    to.add(place, 1, 1, -w.heading * turn);
  } else if (from_moves) {
    const BlockPlace place = to.matrix.place(edge.from, edge.to);
    to.add(place, 0, 0, -w.position);
    to.add(place, 1, 0, -w.position * std::conj(step));
    to.add(place, 1, 1, -w.heading * std::conj(turn));
  }
}

}  // namespace

SlotPoses joint_headings(const SolverGraph& graph, std::span<const double> weights,
                         double position_share) {
  Equations equations{BlockCholesky<4>(graph.supernodes),
                      std::vector<double>(at(graph.variable_count) * 4, 0.0)};
  equations.matrix.clear();
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const SolverEdge& edge = graph.edges[e];
    const double weight = weights.empty() ? 1.0 : weights[e];
    if (weight == 0.0) continue;
    const double position =
        0.5 * position_share * weight * (edge.information[0] + edge.information[2]);
    add_edge(edge, {position, weight * edge.information[5]}, graph.variable_count, equations);
  }
  for (const SolverHeading& heading : graph.headings) {
    equations.add(equations.matrix.place(heading.slot, heading.slot), 1, 1, heading.information);
    equations.add_right(heading.slot, 1, std::polar(heading.information, heading.theta_rad));
  }
  for (const Anchor& anchor : graph.anchors) {
    equations.add(equations.matrix.place(anchor.slot, anchor.slot), 0, 0, anchor.information);
  }
  if (equations.matrix.factorize() != -1) return {};
  equations.matrix.solve(equations.right_side.data());
  SlotPoses state(graph.slot.size() * 3, 0.0);
  for (std::size_t k = 0; k < at(graph.variable_count); ++k) {
    const double* const z = equations.right_side.data() + k * 4 + 2;
    state[k * 3 + 2] = std::atan2(z[1], z[0]);
  }
  return state;
}

}  // namespace roomatlas
