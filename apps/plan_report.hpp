// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/pipeline/pipeline.hpp"

namespace roomatlas::apps {

/// Tables of rooms, walls, spans and consistency for people, on stdout.
void print_plan_evaluation(const Evaluation& evaluation);

}  // namespace roomatlas::apps
