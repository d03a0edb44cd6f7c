// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draw/draw.hpp"

#include "sheet.hpp"
#include "style.hpp"
#include "svg.hpp"
#include "title_block.hpp"

#include <algorithm>
#include <array>

namespace roomatlas {
namespace {

using namespace drawing;

// Sizes on the page.
constexpr double kGutter_mm = 6.0;
constexpr double kCaption_mm = 9.0;
constexpr double kFooter_mm = 14.0;
constexpr double kInner_mm = 4.0;  // between a panel's frame and what it shows
constexpr double kTallestPanel_mm = 180.0;
constexpr double kLowestPanel_mm = 50.0;  // a caption and a path fit in
constexpr double kPanelWidth_mm = (kComparison_mm - 2.0 * kComparisonEdge_mm - kGutter_mm) / 2.0;

Polyline finite_part(const Polyline& line) {
  Polyline finite;
  std::copy_if(line.begin(), line.end(), std::back_inserter(finite),
               [](const Point2& point) { return point.allFinite(); });
  return finite;
}

Box2 box_of(const WallSketch& sketch) {
  Box2 box = bounds(finite_part(sketch.trajectory));
  for (const Polyline& wall : sketch.walls) {
    for (const Point2& point : finite_part(wall)) box.extend(point);
  }
  return box;
}

/// Fits both sketches into panels of one size.
struct Panels {
  int scale = 50;                      ///< 1 to this
  double height_mm = kLowestPanel_mm;  ///< of a panel
};

Panels panels_for(const Point2& largest_m) {
  const Point2 space_mm(kPanelWidth_mm - 2.0 * kInner_mm, kTallestPanel_mm - 2.0 * kInner_mm);
  Panels panels;
  panels.scale = fine_scale((largest_m * kMillimetres).cwiseQuotient(space_mm).maxCoeff());
  panels.height_mm =
      std::max(kLowestPanel_mm, largest_m.y() * kMillimetres / panels.scale + 2.0 * kInner_mm);
  return panels;
}

void add_panel(pugi::xml_node svg, const char* id, const WallSketch& sketch, const Box2& frame,
               double mm_per_m) {
  pugi::xml_node panel = add_group(svg, id);
  add_text(panel, {frame.min.x(), frame.min.y() - 2.5},
           shortened(sketch.caption, kPanelWidth_mm, 4.0, Weight::bold),
           {4.0, Weight::bold, Anchor::start, kInk});
  add_rectangle(panel, frame,
                {{"fill", "#fbfcfd"}, {"stroke", "#cbd2d9"}, {"stroke-width", kThin_mm}});
  const Box2 box = box_of(sketch);
  if (box.empty()) {
    add_text(panel, (frame.min + frame.max) / 2.0, "nothing to draw",
             {3.2, Weight::normal, Anchor::middle, kFaintInk});
    return;
  }
  const Point2 centre_mm = (frame.min + frame.max) / 2.0;
  const Point2 centre_m = (box.min + box.max) / 2.0;
  const PaperTransform to_paper{
      mm_per_m, {centre_mm.x() - mm_per_m * centre_m.x(), centre_mm.y() + mm_per_m * centre_m.y()}};
  std::string walls;
  for (const Polyline& wall : sketch.walls) walls += path_of(to_paper(finite_part(wall)));
  const Attributes line = {
      {"fill", "none"}, {"stroke-linejoin", "round"}, {"stroke-linecap", "round"}};
  pugi::xml_node wall_path = add(panel, "path", line);
  wall_path.append_attribute("class") = "walls";
  wall_path.append_attribute("stroke") = kInk;
  wall_path.append_attribute("stroke-width") = kThin_mm;
  wall_path.append_attribute("d") = walls.c_str();
  pugi::xml_node path = add(panel, "path", line);
  path.append_attribute("class") = "trajectory";
  path.append_attribute("stroke") = kPathStroke;
  path.append_attribute("stroke-width") = kThin_mm;
  path.append_attribute("stroke-opacity") = "0.8";
  path.append_attribute("d") = path_of(to_paper(finite_part(sketch.trajectory))).c_str();
}

void add_footer(pugi::xml_node svg, double top_mm, int scale) {
  pugi::xml_node footer = add_group(svg, "footer");
  add_scale_bar(footer, {kComparisonEdge_mm + 1.0, top_mm + 4.0}, 60.0, kMillimetres / scale);
  const double baseline = top_mm + 6.0;
  double x = 100.0;
  const auto add_key = [&](const char* name, const char* stroke, const char* width) {
    add_line(footer, {x, baseline - 0.9}, {x + 8.0, baseline - 0.9},
             {{"stroke", stroke}, {"stroke-width", width}});
    add_text(footer, {x + 10.0, baseline}, name, {2.6, Weight::normal, Anchor::start, kInk});
    x += 40.0;
  };
  add_key("walls", kInk, "0.4");
  add_key("path driven", kPathStroke, "0.4");
  add_text(footer, {kComparison_mm - kComparisonEdge_mm, baseline},
           "1\u2009:\u2009" + std::to_string(scale) + ", both panels",
           {2.6, Weight::normal, Anchor::end, kFaintInk});
}

}  // namespace

std::string draw_before_after(const WallSketch& before, const WallSketch& after) {
  const Point2 largest_m = box_of(before).size().cwiseMax(box_of(after).size());
  const Panels panels = panels_for(largest_m);
  const double top = kComparisonEdge_mm + kCaption_mm;
  const double bottom = top + panels.height_mm;
  pugi::xml_document document;
  pugi::xml_node svg = add_page(document, kComparison_mm, bottom + kFooter_mm, "Before and after");
  const double mm_per_m = kMillimetres / panels.scale;
  const double second = kComparisonEdge_mm + kPanelWidth_mm + kGutter_mm;
  add_panel(svg, "before", before,
            {{kComparisonEdge_mm, top}, {kComparisonEdge_mm + kPanelWidth_mm, bottom}}, mm_per_m);
  add_panel(svg, "after", after, {{second, top}, {second + kPanelWidth_mm, bottom}}, mm_per_m);
  add_footer(svg, bottom, panels.scale);
  return to_text(document);
}

}  // namespace roomatlas
