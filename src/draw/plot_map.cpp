// SPDX-License-Identifier: GPL-3.0-or-later
#include "axis.hpp"
#include "plot_frame.hpp"
#include "style.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace roomatlas {
namespace {

using namespace drawing;

// Sizes on the page.
constexpr double kPageWidth_mm = 200.0;
constexpr double kEdge_mm = 8.0;
constexpr double kTop_mm = 14.0;
constexpr double kBar_mm = 22.0;       // the colour bar with its numbers, on the right
constexpr double kBarRow_mm = 10.0;    // the bar of lengths
constexpr double kTallest_mm = 190.0;  // map
constexpr int kColours = 24;           // steps of the bar; more make many short lines of a path

/// From yellow over grey to dark blue, evenly darker, readable for every kind of colour vision.
std::string colour_at(double share) {
  struct Rgb {
    double r, g, b;
  };
  // Evenly spaced along the bar.
  constexpr std::array kStops = {Rgb{225, 200, 70}, Rgb{165, 156, 116}, Rgb{112, 113, 120},
                                 Rgb{59, 73, 108}, Rgb{0, 34, 78}};
  const double place = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
  const double part = place - static_cast<double>(below);
  const auto mix = [&](double a, double b) {
    return static_cast<int>(std::lround(a + part * (b - a)));
  };
  const Rgb& from = kStops[below];
  const Rgb& to = kStops[below + 1];
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", static_cast<unsigned>(mix(from.r, to.r)),
                static_cast<unsigned>(mix(from.g, to.g)), static_cast<unsigned>(mix(from.b, to.b)));
  return text;
}

double percentile_95(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(values.size() - 1)))];
}

void add_colour_bar(pugi::xml_node svg, const Axis& axis, const std::string& label,
                    const Box2& box) {
  pugi::xml_node bar = add_group(svg, "scale");
  const double step_mm = box.size().y() / kColours;
  for (int i = 0; i < kColours; ++i) {
    const double bottom_mm = box.max.y() - i * step_mm;
    Box2 cell;
    cell.min = {box.min.x(), bottom_mm - step_mm};
    cell.max = {box.max.x(), bottom_mm + (i > 0 ? 0.05 : 0.0)};  // no seam between the cells
    add_rectangle(bar, cell, {{"fill", colour_at((i + 0.5) / kColours)}});
  }
  for (const double tick : axis.ticks) {
    const double y_mm = box.max.y() - box.size().y() * axis.share(tick);
    add_text(bar, {box.max.x() + 1.5, y_mm + 1.0}, tick_text(axis, tick),
             {2.8, Weight::normal, Anchor::start, kInk});
  }
  add_text(bar, {box.max.x() + 10.0, box.min.y() - 3.5}, label,
           {2.8, Weight::normal, Anchor::end, kInk});
}

void add_length_bar(pugi::xml_node svg, const Point2& at, double mm_per_m) {
  const double length_m = round_step(25.0 / mm_per_m);
  pugi::xml_node bar = add_group(svg, "length");
  add_line(bar, at, {at.x() + length_m * mm_per_m, at.y()},
           {{"stroke", kInk}, {"stroke-width", "0.5"}});
  add_text(bar, {at.x() + length_m * mm_per_m + 2.0, at.y() + 1.0}, number(length_m) + " m",
           {2.8, Weight::normal, Anchor::start, kInk});
}

/// One path for each colour, the darkest last, so that large errors lie on top.
void add_places(pugi::xml_node svg, const Polyline& places_mm, const std::vector<double>& shares) {
  std::array<std::string, kColours> paths;
  for (std::size_t i = 0; i < places_mm.size(); ++i) {
    const int colour = std::min(kColours - 1, static_cast<int>(shares[i] * kColours));
    paths[static_cast<std::size_t>(colour)] +=
        "M" + number(places_mm[i].x()) + " " + number(places_mm[i].y()) + "h0";
  }
  pugi::xml_node group = add_group(
      svg, "places", {{"fill", "none"}, {"stroke-linecap", "round"}, {"stroke-width", "1.1"}});
  for (int i = 0; i < kColours; ++i) {
    const std::string& path = paths[static_cast<std::size_t>(i)];
    if (!path.empty())
      add(group, "path", {{"d", path}, {"stroke", colour_at((i + 0.5) / kColours)}});
  }
}

}  // namespace

std::string plot_map(const std::string& title, const std::string& value_label,
                     const Polyline& places_m, const std::vector<double>& values,
                     const Polyline& reference_m) {
  Polyline places;
  std::vector<double> shown;
  Box2 box = bounds(reference_m);
  for (std::size_t i = 0; i < places_m.size(); ++i) {
    if (!places_m[i].allFinite() || !std::isfinite(values[i])) continue;
    places.push_back(places_m[i]);
    shown.push_back(values[i]);
    box.extend(places_m[i]);
  }
  if (places.empty()) return empty_plot(title);

  const double wide_mm = kPageWidth_mm - 2.0 * kEdge_mm - kBar_mm;
  const Point2 size_m = box.size().cwiseMax(Point2(1.0, 1.0));
  const double mm_per_m = std::min(wide_mm / size_m.x(), kTallest_mm / size_m.y());
  const double tall_mm = std::max(50.0, mm_per_m * size_m.y());
  pugi::xml_document document;
  pugi::xml_node svg =
      add_page(document, kPageWidth_mm, kTop_mm + tall_mm + kBarRow_mm + kEdge_mm, title);
  add_text(svg, {kEdge_mm, 8.0},
           shortened(title, kPageWidth_mm - 2.0 * kEdge_mm, 3.6, Weight::bold),
           {3.6, Weight::bold, Anchor::start, kInk});
  const auto on_paper = [&](const Point2& point) {
    return Point2(kEdge_mm + mm_per_m * (point.x() - box.min.x()),
                  kTop_mm + tall_mm - mm_per_m * (point.y() - box.min.y()));
  };
  Polyline reference_mm;
  for (const Point2& point : reference_m) reference_mm.push_back(on_paper(point));
  add(svg, "path",
      {{"d", path_of(reference_mm)},
       {"fill", "none"},
       {"stroke", "#c9ced6"},
       {"stroke-width", "0.3"}});

  const Axis axis = linear_axis(0.0, percentile_95(shown), 6);
  std::vector<double> shares;
  Polyline places_mm;
  for (std::size_t i = 0; i < places.size(); ++i) {
    places_mm.push_back(on_paper(places[i]));
    shares.push_back(axis.share(shown[i]));
  }
  add_places(svg, places_mm, shares);
  Box2 bar;
  bar.min = {kPageWidth_mm - kEdge_mm - 14.0, kTop_mm + 6.0};
  bar.max = {kPageWidth_mm - kEdge_mm - 10.0, kTop_mm + std::min(tall_mm, 70.0)};
  add_colour_bar(svg, axis, value_label, bar);
  add_length_bar(svg, {kEdge_mm, kTop_mm + tall_mm + kBarRow_mm}, mm_per_m);
  return to_text(document);
}

}  // namespace roomatlas
