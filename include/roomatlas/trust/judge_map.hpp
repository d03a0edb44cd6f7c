// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "roomatlas/assembly/assembly.hpp"
#include "roomatlas/trust/map_figures.hpp"

namespace roomatlas {

/// How far a corrected map can be relied on. Probabilities are logistic in the figures, error bars
/// log-linear; what they weigh was learnt from simulated missions whose truth is known, and is
/// calibrated on others (docs/trust.md; `./run bench trust`).
/// A map that took the place of one that was doubted is given the mean of both log odds.
/// @param figures of that map; nothing is judged where they are empty
[[nodiscard]] std::optional<Judgement> judge_map(const MapFigures& figures,
                                                 const Assembly& assembly);

/// Adds what to drive for a surer map, where it is doubtful.
/// @param assembly as it was judged, with its plan
/// @param correct options of the correction
void advise(const Assembly& assembly, const CorrectOptions& correct, Judgement& judgement);

/// The same judgement where the assembly's rooms have got other numbers; advice too. One that an
/// earlier release measured otherwise stays what was said then.
[[nodiscard]] Judgement judged_anew(const Judgement& judgement, const Assembly& assembly);

}  // namespace roomatlas
