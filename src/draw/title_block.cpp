// SPDX-License-Identifier: GPL-3.0-or-later
#include "title_block.hpp"

#include "compass.hpp"
#include "legend.hpp"
#include "room_labels.hpp"
#include "style.hpp"
#include "svg.hpp"

#include <algorithm>
#include <array>

namespace roomatlas::drawing {
namespace {

constexpr double kInset_mm = 3.0;                                        // of text in its cell
constexpr double kLine_mm = 4.9;                                         // between lines of text
constexpr double kText_mm = 2.4;                                         // height of letters
constexpr std::array<double, 4> kCellShares = {0.27, 0.25, 0.27, 0.21};  // of the strip's width
constexpr int kLines = 5;                                                // of text in a cell

/// A cell of the strip, and where its next line of text goes.
struct Cell {
  Box2 box;
  [[nodiscard]] double left() const { return box.min.x() + kInset_mm; }
  [[nodiscard]] double width() const { return box.size().x() - 2.0 * kInset_mm; }
  [[nodiscard]] double baseline(int line) const { return box.min.y() + 5.6 + line * kLine_mm; }
};

std::array<Cell, 4> cells_of(const Box2& strip) {
  std::array<Cell, 4> cells;
  double x = strip.min.x();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double next = x + kCellShares[i] * strip.size().x();
    cells[i].box = {{x, strip.min.y()}, {next, strip.max.y()}};
    x = next;
  }
  return cells;
}

std::vector<std::string> lines_of(const PlanAnnotations& annotations) {
  std::vector<std::string> lines;
  if (!annotations.mission.empty()) {
    const char* const kind = annotations.path_length_m > 0.0 ? "Mission " : "Map ";
    lines.push_back(kind + annotations.mission);
  }
  if (!annotations.date.empty()) lines.push_back("Recorded " + annotations.date);
  return lines;
}

void add_heading(pugi::xml_node group, const Cell& cell, const TitleStrip& strip) {
  const double width = cell.width() - 2.0 * kCompassRadius_mm;  // but for the line below it
  const auto add_row = [&](int line, const std::string& text, const TextStyle& style) {
    add_text(group, {cell.left(), cell.baseline(line) + (line > 0 ? 0.6 : 0.0)},
             shortened(text, line < 4 ? width : cell.width(), style.size_mm, style.weight), style);
  };
  double title_mm = 4.2;
  while (title_mm > 2.6 && text_width_mm(strip.title, title_mm, Weight::bold) > width) {
    title_mm -= 0.2;
  }
  add_row(0, strip.title, {title_mm, Weight::bold, Anchor::start, kInk});
  int line = 1;
  for (const std::string& text : strip.lines) {
    add_row(line++, text, {kText_mm, Weight::normal, {}, kInk});
  }
  add_row(4, "Measured by a robot. Not a survey.", {2.1, Weight::normal, {}, kFaintInk});
}

std::string accuracy_text(double accuracy_m) {
  return "\u00b1\u00a0" + fixed(accuracy_m, accuracy_m < 1.0 ? 2 : 1) + "\u00a0m";
}

/// Whole percents; never 100, which nobody can know.
std::string percent_text(double probability) {
  return fixed(std::min(99.0, 100.0 * probability), 0) + "\u00a0%";
}

std::vector<Fact> accuracy_facts(const PlanAccuracy& accuracy) {
  std::vector<Fact> facts;
  if (accuracy.probability) {
    facts.push_back({"Map right, probability", percent_text(*accuracy.probability)});
  }
  if (accuracy.within_room_m) {
    facts.push_back({"Walls of a room (1\u00a0\u03c3)", accuracy_text(*accuracy.within_room_m)});
  }
  if (accuracy.between_rooms_m) {
    facts.push_back({"Places of rooms (90\u00a0%)", accuracy_text(*accuracy.between_rooms_m)});
  }
  if (accuracy.over_building_m) {
    facts.push_back({"Over " + fixed(accuracy.extent_m, 0) + "\u00a0m (90\u00a0%)",
                     accuracy_text(*accuracy.over_building_m)});
  }
  return facts;
}

std::vector<Fact> facts_of(const FloorPlan& plan, const PlanAnnotations& annotations) {
  double area_m2 = 0.0;
  for (const PlanRoom& room : plan.rooms) area_m2 += room.area_m2;
  std::vector<Fact> facts = {{"Rooms", std::to_string(plan.rooms.size())},
                             {"Doors", std::to_string(count_of(plan, DoorKind::door))},
                             {"Floor area", area_text(area_m2)}};
  if (annotations.path_length_m > 0.0) {
    facts.push_back({"Path driven", fixed(annotations.path_length_m, 0) + "\u00a0m"});
  }
  if (annotations.accuracy) {
    const auto more = accuracy_facts(*annotations.accuracy);
    facts.insert(facts.end(), more.begin(), more.end());
  }
  return facts;
}

void add_facts(pugi::xml_node group, const Cell& cell, const std::vector<Fact>& facts) {
  const double pitch_mm = kLines * kLine_mm / std::max(kLines, static_cast<int>(facts.size()));
  const double size_mm = std::min(kText_mm, 0.72 * pitch_mm);
  double baseline = cell.baseline(0) - (kText_mm - size_mm);
  for (const Fact& fact : facts) {
    const bool is_note = fact.value.empty();
    add_text(group, {cell.left(), baseline},
             shortened(fact.name, cell.width(), size_mm, Weight::normal),
             {is_note ? 0.9 * size_mm : size_mm, Weight::normal, Anchor::start, kFaintInk});
    if (!is_note) {
      add_text(group, {cell.left() + cell.width(), baseline}, fact.value,
               {size_mm, Weight::bold, Anchor::end, kInk});
    }
    baseline += pitch_mm;
  }
}

}  // namespace

void add_scale_bar(pugi::xml_node parent, const Point2& at, double longest_mm, double mm_per_m) {
  // Of the bar.
  constexpr double kHeight_mm = 1.6;
  constexpr int kParts = 4;
  const double length_m = round_length_m(longest_mm / mm_per_m);
  const double part_mm = length_m * mm_per_m / kParts;
  pugi::xml_node group =
      add_group(parent, "scale-bar", {{"stroke", kInk}, {"stroke-width", kHairline_mm}});
  for (int i = 0; i < kParts; ++i) {
    const Point2 corner(at.x() + i * part_mm, at.y());
    add_rectangle(group, {corner, corner + Point2(part_mm, kHeight_mm)},
                  {{"fill", i % 2 == 0 ? kInk : "#ffffff"}});
  }
  for (const int i : {0, kParts / 2, kParts}) {
    const std::string unit = i == kParts ? "\u00a0m" : "";
    add_text(group, {at.x() + i * part_mm, at.y() + kHeight_mm + 3.0},
             number(length_m * i / kParts) + unit, {2.2, {}, Anchor::middle, kInk})
        .append_attribute("stroke") = "none";
  }
}

void add_title_strip(pugi::xml_node svg, const TitleStrip& strip, const Sheet& sheet) {
  pugi::xml_node group = add_layer(svg, "title");
  const Attributes frame = {{"fill", "none"}, {"stroke", kInk}, {"stroke-width", kFrame_mm}};
  add_rectangle(group, sheet.strip_mm, frame);
  const auto cells = cells_of(sheet.strip_mm);
  for (std::size_t i = 1; i < cells.size(); ++i) {
    add_line(group, cells[i].box.min, {cells[i].box.min.x(), cells[i].box.max.y()},
             {{"stroke", kInk}, {"stroke-width", kHairline_mm}});
  }
  add_heading(group, cells[0], strip);
  add_compass(group,
              {cells[0].box.max.x() - kCompassRadius_mm - 1.5,
               cells[0].box.min.y() + kCompassRadius_mm + 1.5},
              strip.north_deg, sheet.turn_rad);
  add_facts(group, cells[1], strip.facts);
  const Box2 legend{{cells[2].left(), cells[2].box.min.y()},
                    {cells[2].box.max.x() - kInset_mm, cells[2].box.max.y()}};
  add_legend(group, legend, strip.legend);
  const Cell& last = cells[3];
  add_text(group, {last.left(), last.baseline(0)}, "Scale", {kText_mm, {}, {}, kFaintInk});
  add_text(group, {last.left() + last.width(), last.baseline(0)},
           "1\u2009:\u2009" + std::to_string(sheet.scale),
           {kText_mm, Weight::bold, Anchor::end, kInk});
  add_text(group, {last.left(), last.baseline(1)}, "Paper", {kText_mm, {}, {}, kFaintInk});
  add_text(group, {last.left() + last.width(), last.baseline(1)}, sheet.paper,
           {kText_mm, {}, Anchor::end, kInk});
  add_text(group, {last.left(), last.baseline(2)}, "Lengths", {kText_mm, {}, {}, kFaintInk});
  add_text(group, {last.left() + last.width(), last.baseline(2)}, "metres",
           {kText_mm, {}, Anchor::end, kInk});
  add_scale_bar(group, {last.left() + 1.0, last.box.min.y() + 20.0}, last.width() - 6.0,
                sheet.to_paper.mm_per_m);
}

void add_title_block(pugi::xml_node svg, const FloorPlan& plan, const PlanAnnotations& annotations,
                     const DrawOptions& options, const Sheet& sheet) {
  const bool has_title = !plan.title.empty() && plan.title != annotations.mission;
  add_title_strip(
      svg,
      {has_title ? plan.title : "Floor plan", lines_of(annotations), facts_of(plan, annotations),
       legend_of(plan, annotations, options, sheet.scale), options.north_deg},
      sheet);
}

}  // namespace roomatlas::drawing
