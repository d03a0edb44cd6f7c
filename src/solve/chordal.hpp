// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "linearise.hpp"

namespace roomatlas {

/// Headings from the measured rotations alone, globally and without a start: the least squares of
/// |z_to - exp(i theta) z_from|^2 over complex numbers z of any length is linear (Martinec and
/// Pajdla 2007; Carlone et al. 2015, "chordal"). Fixed nodes have heading 0.
/// @param headings whether measured headings count: without, components that they turn start at 0
/// @return a state with all positions zero, or an empty one where the system is singular
[[nodiscard]] SlotPoses chordal_headings(const SolverGraph& graph, std::span<const double> weights,
                                         bool headings = true);

}  // namespace roomatlas
