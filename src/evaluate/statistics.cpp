// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

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
  double deviations = 0.0;
  result.sse = 0.0;
  for (const double value : values) {
    deviations += (value - result.mean) * (value - result.mean);
    result.sse += value * value;
  }
  result.standard_deviation = std::sqrt(deviations / count);
  result.mean_square = result.sse / count;
  result.rmse = std::sqrt(result.mean_square);
  const std::size_t upper = values.size() / 2;
  result.median =
      values.size() % 2 == 1 ? values[upper] : (values[upper - 1] + values[upper]) / 2.0;
  result.minimum = values.front();
  result.maximum = values.back();
  return result;
}

std::array<std::pair<const char*, double>, 7> named(const Statistics& s) {
  return {{{"rmse", s.rmse},
           {"mean", s.mean},
           {"median", s.median},
           {"std", s.standard_deviation},
           {"min", s.minimum},
           {"max", s.maximum},
           {"sse", s.sse}}};
}

}  // namespace roomatlas
