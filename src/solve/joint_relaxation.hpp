// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "linearise.hpp"

namespace roomatlas {

/// Headings from all measurements at once, positions too, without a start: with complex numbers z
/// of any length for the rotations and t for the positions,
///   w_position |t_to - t_from - z_from step|^2 + w_heading |z_to - exp(i theta) z_from|^2
/// is a linear problem (the relaxation of SE-Sync, Rosen et al. 2019, before its semidefinite
/// part). Where headings are poorly measured, positions tell them. Position information counts as
/// if it were the same in all directions.
/// @param position_share scales w_position
/// @return a state with all positions zero, or an empty one where the system is singular
[[nodiscard]] SlotPoses joint_headings(const SolverGraph& graph, std::span<const double> weights,
                                       double position_share);

}  // namespace roomatlas
