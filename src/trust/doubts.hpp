// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "learnt_model.hpp"
#include "roomatlas/assembly/assembly.hpp"

namespace roomatlas {

/// What lowers the probability, in words: figures that are worse than usual, and rooms that hang on
/// one passage. The strongest first.
[[nodiscard]] std::vector<Doubt> doubts_of(const LearntSum& right,
                                           const std::vector<JudgedFigure>& figures,
                                           const Assembly& assembly);

}  // namespace roomatlas
