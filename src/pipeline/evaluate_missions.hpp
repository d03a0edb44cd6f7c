// SPDX-License-Identifier: GPL-3.0-or-later
// A store of several missions against the truth.
#pragma once

#include "roomatlas/pipeline/evaluate_store.hpp"

namespace roomatlas {

/// All missions together, and each in the building's frame; see `evaluate_store`.
[[nodiscard]] Evaluation evaluate_missions(const AssemblyStore& store, const Truth& truth,
                                           const TrajectoryPreparation& preparation, int jobs);

}  // namespace roomatlas
