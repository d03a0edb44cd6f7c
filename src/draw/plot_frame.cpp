// SPDX-License-Identifier: GPL-3.0-or-later
#include "plot_frame.hpp"

#include "style.hpp"

#include "roomatlas/core/median.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace roomatlas::drawing {
namespace {

// Sizes on the page.
constexpr double kPageWidth_mm = 200.0;
constexpr double kPlotHeight_mm = 90.0;
constexpr double kLeft_mm = 22.0;
constexpr double kRight_mm = 8.0;
constexpr double kTop_mm = 14.0;
constexpr double kBottom_mm = 16.0;
constexpr double kLegendLine_mm = 5.0;
constexpr double kTextSize_mm = 2.8;
constexpr const char* kGrid = "#e4e7eb";

}  // namespace

std::string series_colour(std::size_t number) {
  // Told apart by every kind of colour vision (Okabe and Ito).
  constexpr std::array kColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                   "#e69f00", "#56b4e9", "#000000"};
  return kColours[number % kColours.size()];
}

std::string empty_plot(const std::string& title) {
  pugi::xml_document document;
  pugi::xml_node svg = add_page(document, kPageWidth_mm, 40.0, title);
  add_text(svg, {kPageWidth_mm / 2.0, 12.0}, title, {3.6, Weight::bold, Anchor::middle, kInk});
  add_text(svg, {kPageWidth_mm / 2.0, 24.0}, "nothing to draw",
           {3.2, Weight::normal, Anchor::middle, kFaintInk});
  return to_text(document);
}

std::optional<Axis> value_axis(const std::vector<PlotSeries>& series, int most) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  std::vector<double> medians;
  for (const PlotSeries& one : series) {
    std::vector<double> finite;
    std::copy_if(one.y.begin(), one.y.end(), std::back_inserter(finite),
                 [](double value) { return std::isfinite(value); });
    if (finite.empty()) continue;
    medians.push_back(median(finite));
    low = std::min(low, *std::min_element(finite.begin(), finite.end()));
    high = std::max(high, *std::max_element(finite.begin(), finite.end()));
  }
  if (medians.empty()) return std::nullopt;
  const double least_median = *std::min_element(medians.begin(), medians.end());
  constexpr double kVeryDifferent = 100.0;  // times the least median: then powers of ten
  if (low >= 0.0 && least_median > 0.0 && high > kVeryDifferent * least_median) {
    return logarithmic_axis(least_median / 10.0, high);  // single tiny values would stretch it
  }
  return linear_axis(std::min(low, 0.0), high, most);
}

PlotFrame::PlotFrame(const PlotLabels& labels, Axis x, Axis y, std::size_t legend_lines)
    : x_(std::move(x)), y_(std::move(y)) {
  const double legend_mm = kLegendLine_mm * static_cast<double>(legend_lines);
  frame_.min = {kLeft_mm, kTop_mm};
  frame_.max = {kPageWidth_mm - kRight_mm, kTop_mm + kPlotHeight_mm};
  svg_ = add_page(document_, kPageWidth_mm, frame_.max.y() + kBottom_mm + legend_mm, labels.title);
  add_text(svg_, {kLeft_mm, 8.0},
           shortened(labels.title, kPageWidth_mm - kLeft_mm - kRight_mm, 3.6, Weight::bold),
           {3.6, Weight::bold, Anchor::start, kInk});
  draw_axes(labels);
  content_ = add_group(svg_, "values");
}

Point2 PlotFrame::at(double x, double y) const {
  const Point2 size = frame_.size();
  return {frame_.min.x() + size.x() * x_.share(x), frame_.max.y() - size.y() * y_.share(y)};
}

void PlotFrame::draw_axes(const PlotLabels& labels) {
  pugi::xml_node grid =
      add_group(svg_, "grid", {{"stroke", kGrid}, {"stroke-width", kHairline_mm}});
  pugi::xml_node texts = add_group(svg_, "axes");
  for (const double tick : x_.ticks) {
    const double x_mm = at(tick, y_.low).x();
    add_line(grid, {x_mm, frame_.min.y()}, {x_mm, frame_.max.y()});
    add_text(texts, {x_mm, frame_.max.y() + 4.5}, tick_text(x_, tick),
             {kTextSize_mm, Weight::normal, Anchor::middle, kInk});
  }
  for (const double tick : y_.ticks) {
    const double y_mm = at(x_.low, tick).y();
    add_line(grid, {frame_.min.x(), y_mm}, {frame_.max.x(), y_mm});
    add_text(texts, {frame_.min.x() - 1.5, y_mm + 0.5 * kCapHeight * kTextSize_mm},
             tick_text(y_, tick), {kTextSize_mm, Weight::normal, Anchor::end, kInk});
  }
  add_rectangle(texts, frame_,
                {{"fill", "none"}, {"stroke", kFaintInk}, {"stroke-width", kThin_mm}});
  add_text(texts, {(frame_.min.x() + frame_.max.x()) / 2.0, frame_.max.y() + 10.0}, labels.x,
           {3.0, Weight::normal, Anchor::middle, kInk});
  const Point2 beside(5.5, (frame_.min.y() + frame_.max.y()) / 2.0);
  add_text(texts, beside, labels.y, {3.0, Weight::normal, Anchor::middle, kInk})
      .append_attribute("transform") =
      ("rotate(-90 " + number(beside.x()) + " " + number(beside.y()) + ")").c_str();
}

void PlotFrame::add_legend(std::size_t line, const std::string& name, const std::string& colour) {
  const double y_mm =
      frame_.max.y() + kBottom_mm + kLegendLine_mm * static_cast<double>(line) - 1.0;
  pugi::xml_node legend = add_group(svg_, ("legend-" + std::to_string(line + 1)).c_str());
  add_line(legend, {kLeft_mm, y_mm - 1.0}, {kLeft_mm + 8.0, y_mm - 1.0},
           {{"stroke", colour}, {"stroke-width", "1"}});
  add_text(
      legend, {kLeft_mm + 10.0, y_mm},
      shortened(name, kPageWidth_mm - kLeft_mm - kRight_mm - 10.0, kTextSize_mm, Weight::normal),
      {kTextSize_mm, Weight::normal, Anchor::start, kInk});
}

}  // namespace roomatlas::drawing
