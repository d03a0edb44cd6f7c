// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/evaluate/evaluation.hpp"
#include "text/json_fwd.hpp"

namespace roomatlas::io {

/// Adds what is known of missions, rooms, walls and consistency to the object of an evaluation.
void add_plan_evaluation(Json& json, const Evaluation& evaluation);

}  // namespace roomatlas::io
