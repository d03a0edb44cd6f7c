// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

#include <string>
#include <vector>

namespace roomatlas {

struct PlotLabels {
  std::string title;
  std::string x;  ///< what the axis shows, with its unit
  std::string y;
};

/// Values of one run. Values that are not finite are not drawn.
struct PlotSeries {
  std::string name;
  std::vector<double> x;  ///< as many as `y`
  std::vector<double> y;
};

/// Values over x as an SVG page, a colour and a kind of mark for each series, joined by lines or
/// as points. Ticks are round numbers. Positive values of very different size get a logarithmic
/// axis. Nothing to draw gives a page that says so.
[[nodiscard]] std::string plot_over(const PlotLabels& labels, const std::vector<PlotSeries>& series,
                                    bool is_joined);

/// How the values `y` of each series are spread, in percent of the series, in common bins with
/// round limits.
[[nodiscard]] std::string plot_histogram(const PlotLabels& labels,
                                         const std::vector<PlotSeries>& series);

/// Places with a value each, which their colour shows: the darker the larger. The scale ends at
/// the 95th percentile; what is beyond has its last colour.
/// @param reference_m a path to draw beneath in grey; may be empty
[[nodiscard]] std::string plot_map(const std::string& title, const std::string& value_label,
                                   const Polyline& places_m, const std::vector<double>& values,
                                   const Polyline& reference_m);

}  // namespace roomatlas
