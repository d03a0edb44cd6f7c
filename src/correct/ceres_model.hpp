// SPDX-License-Identifier: GPL-3.0-or-later
// What both models do with Ceres. Included only below src/correct.
#pragma once

#include <ceres/problem.h>

#include "models.hpp"

namespace roomatlas {

/// A residual block, and what it stands for.
struct ReportedFactor {
  ceres::ResidualBlockId block = nullptr;
  FactorReport report;
  bool is_robust = false;
};

/// Chi-square of a factor at the parameters' present values, without its robust loss.
[[nodiscard]] double chi_square(const ceres::Problem& problem, const ReportedFactor& factor);

/// Solves, and fills costs, reports and the verdict of `result`.
void solve(ceres::Problem& problem, std::vector<ReportedFactor>& factors,
           const CorrectOptions& options, ModelResult& result);

/// A factor known both by its heading and its position block counts once.
[[nodiscard]] FactorReport report_of(const Measurements& measurements,
                                     const Measurements::Edge& edge, FactorKind kind);

}  // namespace roomatlas
