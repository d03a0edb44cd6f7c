// SPDX-License-Identifier: GPL-3.0-or-later
// Ridge regression of log odds or of logarithms on standardised figures.
#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

#include "roomatlas/core/learnt_sum.hpp"
#include "roomatlas/plan/judgement.hpp"

namespace roomatlas::bench {

struct FitTerm {
  std::string name;
  double mean = 0.0;
  double deviation = 1.0;
  double weight = 0.0;
};

struct FitSum {
  double bias = 0.0;
  std::vector<FitTerm> terms;
  [[nodiscard]] double at(const std::vector<JudgedFigure>& figures) const;
};

/// What a sum is fitted to: figures, the target (0 or 1, or a logarithm: see `FitKind`), and what
/// belongs together when some is left out.
struct FitRow {
  std::vector<JudgedFigure> figures;
  double target = 0.0;
  std::size_t group = 0;
};

enum class FitKind {
  log_odds,
  within_limit,  ///< the target is a logarithm, 0 at the limit; fitted to it are log odds that it
                 ///< is not above, that hold but for a share of lapses, in which none of the
                 ///< figures tells that it is. How far beyond says more than whether
  logarithm
};

struct Fitted {
  FitSum sum;
  double lapses = 0.0;           ///< share, [0, 1)
  double penalty = 0.0;          ///< that lost least when groups were left out
  double loss = 0.0;             ///< then: mean negative log likelihood, or mean square
  std::vector<double> left_out;  ///< of each row, by a sum that its group had no part in
};

/// The sum whose penalty loses least on groups that were left out, by tenths. Log odds are
/// calibrated by what was found there (Platt 1999), with the share of lapses that makes it
/// likeliest (as of psychometric functions: Wichmann and Hill 2001); logarithms are raised so that
/// `share` of the left-out targets lie below.
/// @param known the sum that the penalty pulls to, with its means and deviations; none: no weights
[[nodiscard]] Fitted fit_sum(const std::vector<FitRow>& rows, FitKind kind,
                             const std::optional<FitSum>& known = std::nullopt, double share = 0.9);

/// A sum that the library knows.
[[nodiscard]] FitSum known_sum(const LearntSum& sum);

/// The same with targets for log odds: 1 where they are not above 0, else 0.
[[nodiscard]] std::vector<FitRow> whether_within(std::vector<FitRow> rows);

/// How many rows were given so much by sums that their groups had no part in, and how many of these
/// are wrong: a line for each of several probabilities.
/// @param rows with targets that are 0 where it is wrong, else 1
[[nodiscard]] std::string given_text(const std::vector<FitRow>& rows, const Fitted& fitted);

/// As a number, and as an array of `LearntTerm`, of C++.
[[nodiscard]] std::string number_text(double value);
[[nodiscard]] std::string terms_text(const std::string& name, const FitSum& sum);

}  // namespace roomatlas::bench
