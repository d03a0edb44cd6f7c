// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace roomatlas::drawing {

/// A scale from values to [0, 1], and the values that are written beside it.
struct Axis {
  double low = 0.0;
  double high = 1.0;  ///< more than `low`
  bool is_logarithmic = false;
  std::vector<double> ticks;

  /// Where a value lies; values beyond the ends lie at the ends.
  [[nodiscard]] double share(double value) const;
};

/// The smallest of 1, 2, 5 times a power of ten that is not less. Positive input.
[[nodiscard]] double round_step(double at_least);

/// Begins at 0 or at a round value below, ends at a round value above, with at most `most` steps.
[[nodiscard]] Axis linear_axis(double low, double high, int most);
/// From a power of ten to a power of ten. Both limits positive.
[[nodiscard]] Axis logarithmic_axis(double low, double high);

/// The number as short as the axis allows: as many decimals as its steps need.
[[nodiscard]] std::string tick_text(const Axis& axis, double tick);

}  // namespace roomatlas::drawing
