// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/evaluate/compare.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace roomatlas {

/// One line of a comparison: what every table, for people or programs, is made of.
struct Figure {
  std::string run;
  std::string metric;    ///< "relations", "ape" or "rpe"
  std::string subset;    ///< relations: "all", "local" or "loop"; else evo's pose relation
  std::string quantity;  ///< "translation", "rotation" or "error"
  std::string unit;      ///< "m", "deg", "rad", "%" or ""
  std::int64_t covered = 0;
  std::int64_t of = 0;  ///< relations, or poses of the shorter side
  Statistics statistics;
  std::optional<ConfidenceInterval> interval;       ///< of the mean; of "all" alone
  std::optional<ConfidenceInterval> against_first;  ///< mean difference to the first run
  std::int64_t shared = 0;                          ///< errors that the difference is over

  [[nodiscard]] double share() const {
    return of > 0 ? static_cast<double>(covered) / static_cast<double>(of) : 0.0;
  }
};

/// All figures, in the order metric, subset, quantity, run: runs stand below each other.
[[nodiscard]] std::vector<Figure> figures(const Comparison& comparison);

}  // namespace roomatlas
