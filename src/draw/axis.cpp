// SPDX-License-Identifier: GPL-3.0-or-later
#include "axis.hpp"

#include "svg.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas::drawing {

double Axis::share(double value) const {
  if (is_logarithmic) {
    if (!(value > low)) return 0.0;
    return std::clamp(std::log(value / low) / std::log(high / low), 0.0, 1.0);
  }
  return std::clamp((value - low) / (high - low), 0.0, 1.0);
}

double round_step(double at_least) {
  const double power = std::pow(10.0, std::floor(std::log10(at_least)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * power >= at_least * (1.0 - 1e-9)) return step * power;
  }
  return 10.0 * power;
}

Axis linear_axis(double low, double high, int most) {
  if (low > 0.0 && low < 0.3 * high) low = 0.0;
  if (!(high > low)) high = low + 1.0;
  double step = round_step((high - low) / most);
  // Rounding both ends outwards may take a step more than there is room for.
  while (std::ceil(high / step) - std::floor(low / step) > most) step = round_step(step * 1.01);
  Axis axis;
  const double first = std::floor(low / step + 1e-9);
  const double last = std::max(first + 1.0, std::ceil(high / step - 1e-9));
  for (double i = first; i <= last; ++i) axis.ticks.push_back(i * step);
  axis.low = axis.ticks.front();
  axis.high = axis.ticks.back();
  return axis;
}

Axis logarithmic_axis(double low, double high) {
  Axis axis;
  axis.is_logarithmic = true;
  const double first = std::floor(std::log10(low) + 1e-9);
  const double last = std::max(first + 1.0, std::ceil(std::log10(high) - 1e-9));
  for (double i = first; i <= last; ++i) axis.ticks.push_back(std::pow(10.0, i));
  axis.low = axis.ticks.front();
  axis.high = axis.ticks.back();
  return axis;
}

std::string tick_text(const Axis& axis, double tick) {
  const double step = axis.is_logarithmic ? tick : axis.ticks[1] - axis.ticks[0];
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  return fixed(tick, decimals);
}

}  // namespace roomatlas::drawing
