// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>

#include "roomatlas/evaluate/statistics.hpp"

namespace roomatlas {

Statistics statistics(std::vector<double> values) {
  Statistics result;
  result.count = std::ssize(values);
  if (values.empty()) return result;
  for (double& value : values) value = std::abs(value);
  if (std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); })) {
    return result;  // sorting needs an order, which NaN has not
  }
  std::sort(values.begin(), values.end());

  const double count = static_cast<double>(values.size());
  result.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  const double squares =
      std::accumulate(values.begin(), values.end(), 0.0, [&](double sum, double value) {
        return sum + (value - result.mean) * (value - result.mean);
      });
  result.standard_deviation = std::sqrt(squares / count);
  const std::size_t upper = values.size() / 2;
  result.median =
      values.size() % 2 == 1 ? values[upper] : (values[upper - 1] + values[upper]) / 2.0;
  result.maximum = values.back();
  return result;
}

}  // namespace roomatlas
