// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "axis.hpp"
#include "svg.hpp"

#include "roomatlas/draw/plots.hpp"

#include <optional>

namespace roomatlas::drawing {

/// A page with a title, two axes and, once they are known, a legend.
class PlotFrame {
 public:
  PlotFrame(const PlotLabels& labels, Axis x, Axis y, std::size_t legend_lines);

  [[nodiscard]] Point2 at(double x, double y) const;
  [[nodiscard]] pugi::xml_node content() const { return content_; }
  void add_legend(std::size_t line, const std::string& name, const std::string& colour);
  [[nodiscard]] std::string text() const { return to_text(document_); }

 private:
  void draw_axes(const PlotLabels& labels);

  pugi::xml_document document_;
  pugi::xml_node svg_;
  pugi::xml_node content_;
  Axis x_;
  Axis y_;
  Box2 frame_;
};

/// Colours that stay apart for colour-blind readers (Okabe and Ito 2008); they come round again.
[[nodiscard]] std::string series_colour(std::size_t number);

/// A page that says that there is nothing to draw.
[[nodiscard]] std::string empty_plot(const std::string& title);

/// The axis for values of several series: logarithmic where none is negative and the largest is
/// more than a hundred times some series' median. Nothing when no value is finite.
[[nodiscard]] std::optional<Axis> value_axis(const std::vector<PlotSeries>& series, int most);

}  // namespace roomatlas::drawing
