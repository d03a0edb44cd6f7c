// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/evaluate/plan_figures.hpp"

namespace roomatlas::apps {

/// Tables of rooms, walls, spans and consistency for people, on stdout.
void print_plan_evaluation(const Evaluation& evaluation);

/// Several plans side by side: a line a figure, a column a plan.
void print_side_by_side(const std::vector<JudgedPlan>& plans);

}  // namespace roomatlas::apps
