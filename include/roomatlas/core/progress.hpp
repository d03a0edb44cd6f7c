// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "roomatlas/core/issue.hpp"

namespace roomatlas {

/// Called now and then by long stages. `done` is in [0, 1], or negative where unknown.
/// Return false to ask the stage to stop: it throws `Interrupted` at a consistent point.
using Progress = std::function<bool(const std::string& stage, double done)>;

/// Tells how far a stage is. @throws Interrupted when the caller wants no more of it
inline void report(const Progress& progress, const std::string& stage, double done) {
  if (progress && !progress(stage, done)) throw Interrupted("interrupted while assembling");
}

/// The share of a count.
[[nodiscard]] inline double share_of(std::size_t done, std::size_t all) {
  return static_cast<double>(done) / static_cast<double>(all);
}

}  // namespace roomatlas
