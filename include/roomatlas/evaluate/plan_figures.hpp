// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "roomatlas/evaluate/evaluation.hpp"

namespace roomatlas {

/// A run's map, judged: its plan, walls and spans against truth, its placement against itself.
struct JudgedPlan {
  std::string name;
  Evaluation evaluation;
};

/// One figure of one plan: what every table of plans is made of.
struct PlanFigure {
  std::string metric;    ///< "rooms", "doors", "graph", "walls", "spans", "room_poses", "self"
  std::string quantity;  ///< such as "f1 at IoU 0.5"
  std::string unit;      ///< "m", "deg", "%" or ""
  double value = std::numeric_limits<double>::quiet_NaN();
  std::string word;          ///< shown instead of the value where it is not empty: "yes", "better"
  std::int64_t covered = 0;  ///< how many the value counts as right, of ...
  std::int64_t of = 0;       ///< ... so many; 0 where it is not a matter of counting

  /// Whether two plans' figures belong into one line.
  [[nodiscard]] bool is_like(const PlanFigure& other) const {
    return metric == other.metric && quantity == other.quantity;
  }
};

/// The figures of a plan in a fixed order; those without anything to measure are left out. "yes" is
/// 1 and "no" 0; the verdict is 1 for better, -1 for worse, 0 for undecided.
[[nodiscard]] std::vector<PlanFigure> plan_figures(const Evaluation& evaluation);

/// The figures that any of the plans has, each once: the lines of a table.
[[nodiscard]] std::vector<PlanFigure> lines_of(const std::vector<JudgedPlan>& plans);

}  // namespace roomatlas
