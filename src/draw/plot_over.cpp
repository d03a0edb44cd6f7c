// SPDX-License-Identifier: GPL-3.0-or-later
#include "plot_frame.hpp"

#include <cmath>

namespace roomatlas {
namespace {

using namespace drawing;

std::optional<Axis> x_axis_of(const std::vector<PlotSeries>& series) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const PlotSeries& one : series) {
    for (const double x : one.x) {
      if (!std::isfinite(x)) continue;
      low = std::min(low, x);
      high = std::max(high, x);
    }
  }
  if (!(low <= high)) return std::nullopt;
  return linear_axis(low, high, 12);
}

/// All values as one path: a line through them, or a dot at each.
std::string path_of_values(const PlotFrame& frame, const PlotSeries& series, bool is_joined) {
  std::string path;
  bool is_down = false;
  for (std::size_t i = 0; i < series.y.size(); ++i) {
    if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) {
      is_down = false;
      continue;
    }
    const Point2 at = frame.at(series.x[i], series.y[i]);
    path += (is_joined && is_down ? "L" : "M") + number(at.x()) + " " + number(at.y());
    if (!is_joined) path += "h0";
    is_down = true;
  }
  return path;
}

}  // namespace

std::string plot_over(const PlotLabels& labels, const std::vector<PlotSeries>& series,
                      bool is_joined) {
  const std::optional<Axis> x = x_axis_of(series);
  const std::optional<Axis> y = value_axis(series, 8);
  if (!x || !y) return empty_plot(labels.title);
  PlotFrame frame(labels, *x, *y, series.size());
  for (std::size_t i = 0; i < series.size(); ++i) {
    add(frame.content(), "path",
        {{"d", path_of_values(frame, series[i], is_joined)},
         {"fill", "none"},
         {"stroke", series_colour(i)},
         {"stroke-width", is_joined ? "0.3" : "0.7"},
         {"stroke-linecap", "round"},
         {"stroke-linejoin", "round"}});
    frame.add_legend(i, series[i].name, series_colour(i));
  }
  return frame.text();
}

}  // namespace roomatlas
