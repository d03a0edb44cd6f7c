// SPDX-License-Identifier: GPL-3.0-or-later
#include "plot_frame.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

using namespace drawing;

/// The limits of the bins: between the axis's ticks, so that they are round too.
std::vector<double> limits_of(const Axis& axis) {
  constexpr int kBinsBetweenTicks = 5;  // more make the bins of few errors ragged
  std::vector<double> limits;
  for (std::size_t tick = 0; tick + 1 < axis.ticks.size(); ++tick) {
    const double low = axis.ticks[tick];
    const double high = axis.ticks[tick + 1];
    for (int i = 0; i < kBinsBetweenTicks; ++i) {
      const double share = static_cast<double>(i) / kBinsBetweenTicks;
      limits.push_back(axis.is_logarithmic ? low * std::pow(high / low, share)
                                           : low + (high - low) * share);
    }
  }
  limits.push_back(axis.ticks.back());
  return limits;
}

/// Percent of the values in each bin; those beyond the ends belong to the last bins.
std::vector<double> spread(const std::vector<double>& values, const std::vector<double>& limits) {
  std::vector<double> percent(limits.size() - 1, 0.0);
  double count = 0.0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    const auto above = std::upper_bound(limits.begin(), limits.end(), value) - limits.begin();
    const auto bin = std::clamp<std::ptrdiff_t>(above - 1, 0, std::ssize(percent) - 1);
    ++percent[static_cast<std::size_t>(bin)];
    ++count;
  }
  for (double& bin : percent) bin *= count > 0.0 ? 100.0 / count : 0.0;
  return percent;
}

std::string outline(const PlotFrame& frame, const std::vector<double>& limits,
                    const std::vector<double>& percent) {
  Polyline line = {frame.at(limits.front(), 0.0)};
  for (std::size_t i = 0; i < percent.size(); ++i) {
    line.push_back(frame.at(limits[i], percent[i]));
    line.push_back(frame.at(limits[i + 1], percent[i]));
  }
  line.push_back(frame.at(limits.back(), 0.0));
  return path_of(line);
}

}  // namespace

std::string plot_histogram(const PlotLabels& labels, const std::vector<PlotSeries>& series) {
  const std::optional<Axis> x = value_axis(series, 10);
  if (!x) return empty_plot(labels.title);
  const std::vector<double> limits = limits_of(*x);
  std::vector<std::vector<double>> spreads;
  double highest = 0.0;
  for (const PlotSeries& one : series) {
    spreads.push_back(spread(one.y, limits));
    highest = std::max(highest, *std::max_element(spreads.back().begin(), spreads.back().end()));
  }
  PlotFrame frame(labels, *x, linear_axis(0.0, highest, 8), series.size());
  for (std::size_t i = 0; i < series.size(); ++i) {
    add(frame.content(), "path",
        {{"d", outline(frame, limits, spreads[i])},
         {"fill", series_colour(i)},
         {"fill-opacity", "0.2"},
         {"stroke", series_colour(i)},
         {"stroke-width", "0.4"}});
    frame.add_legend(i, series[i].name, series_colour(i));
  }
  return frame.text();
}

}  // namespace roomatlas
