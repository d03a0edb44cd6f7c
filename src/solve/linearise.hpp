// SPDX-License-Identifier: GPL-3.0-or-later
// The normal equations of a pose graph. With d = t_to - t_from, q = d turned by 90 degrees, and
// the error in the frame of `from`, e = [ R_from' d - t ; wrap(...) ], the Jacobians are
//   by to: diag(R_from', 1)     by from: -diag(R_from', 1) T,  T = [ I q ; 0 1 ]
// so that with W the information turned into the world's frame the matrix's blocks are
// W (to, to), -T'W (from, to) and T'WT (from, from).
#pragma once

#include <span>
#include <vector>

#include "solver_graph.hpp"

namespace roomatlas {

/// Poses by slot: x, y, theta one after the other. Fixed nodes stand at the end.
using SlotPoses = std::vector<double>;

/// How the step of an edge enters its Jacobian.
enum class StepSource {
  state,     ///< from the positions: the exact derivative
  measured,  ///< from the measurement: of use where headings are good and positions unknown
};

struct NormalEquations {
  BlockCholesky<3>& matrix;
  const MatrixPlaces<3>& places;
  std::vector<double>& right_side;  ///< minus half the gradient, 3 a position
};

/// Fills the equations of the weighted edges and of the headings. A loss weighs its measurement as
/// its derivative at the state does, but not in steps from the measurements: those start without
/// positions.
/// @param weights one an edge of the SolverGraph, or empty: all 1. Edges of weight 0 are left out
/// @return chi-square at the state, under the losses
double linearise(const SolverGraph& graph, const SlotPoses& state, std::span<const double> weights,
                 StepSource source, NormalEquations& equations);

/// The right side alone. @return chi-square, under the losses
double gradient(const SolverGraph& graph, const SlotPoses& state, std::span<const double> weights,
                std::vector<double>& right_side);

/// Sum of weight times chi-square, under the losses.
/// @param each where given, receives the edges' chi-squares without weight or loss
double chi_square(const SolverGraph& graph, const SlotPoses& state, std::span<const double> weights,
                  std::vector<double>* each = nullptr);

/// Of a measured heading, without its loss.
double chi_square(const SolverHeading& heading, const SlotPoses& state);

}  // namespace roomatlas
