// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/evaluate/evaluation.hpp"
#include "text/json_fwd.hpp"

namespace roomatlas::io {

/// Several missions of a building: who saw which room when, how well they agree, and their errors.
[[nodiscard]] Json json_of(const MissionsEvaluation& missions);

}  // namespace roomatlas::io
