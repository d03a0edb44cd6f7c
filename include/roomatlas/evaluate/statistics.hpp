// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace roomatlas {

/// Statistics of absolute values: the seven that evo has (M. Grupp, github.com/MichaelGrupp/evo),
/// and the mean of the squares, which Kuemmerle et al. report. `count` 0 means that there was
/// nothing to measure; the rest is then NaN.
struct Statistics {
  std::int64_t count = 0;
  double mean = std::numeric_limits<double>::quiet_NaN();
  double standard_deviation = std::numeric_limits<double>::quiet_NaN();  ///< of the population
  double median = std::numeric_limits<double>::quiet_NaN();  ///< even count: mean of the middle two
  double maximum = std::numeric_limits<double>::quiet_NaN();
  double minimum = std::numeric_limits<double>::quiet_NaN();
  double rmse = std::numeric_limits<double>::quiet_NaN();  ///< root of `mean_square`
  double sse = std::numeric_limits<double>::quiet_NaN();   ///< sum of squares
  double mean_square = std::numeric_limits<double>::quiet_NaN();
};

/// The values' absolute values in short; the order of the values does not matter, to the last
/// bit. A NaN among them makes everything but the count NaN: a broken measurement shows.
[[nodiscard]] Statistics statistics(std::vector<double> values);

/// evo's seven by evo's names, in evo's order.
[[nodiscard]] std::array<std::pair<const char*, double>, 7> named(const Statistics& statistics);

}  // namespace roomatlas
