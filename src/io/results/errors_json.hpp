// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/evaluate/evaluation.hpp"
#include "text/json_fwd.hpp"

namespace roomatlas::io {

/// Errors of trajectories as JSON objects; statistics of nothing are null.
[[nodiscard]] Json json_of(const Statistics& statistics);
[[nodiscard]] Json json_of(const RelationSubset& subset);
[[nodiscard]] Json json_of(const RelationErrors& errors);
[[nodiscard]] Json json_of(const TruePoseErrors& errors);

}  // namespace roomatlas::io
