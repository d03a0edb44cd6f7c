// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/assembly/assembly.hpp"
#include "roomatlas/correct/correct.hpp"

namespace roomatlas {

/// What would make the visits' places surer, at most three drives, each in turn the one that lowers
/// the largest variances most a metre once those before it are driven. Nothing where no drive
/// lowers them by a tenth.
/// @param assembly with its plan, whose rooms' numbers are named
/// @param correct options of the correction, by which its measurements are weighed
[[nodiscard]] std::vector<Advice> advice_on(const Assembly& assembly,
                                            const CorrectOptions& correct);

}  // namespace roomatlas
