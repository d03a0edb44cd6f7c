// SPDX-License-Identifier: GPL-3.0-or-later
#include "title_block.hpp"

#include "compass.hpp"
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
constexpr std::array<double, 4> kCellShares = {0.29, 0.24, 0.21, 0.26};  // of the strip's width

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

void add_heading(pugi::xml_node group, const Cell& cell, const FloorPlan& plan,
                 const PlanAnnotations& annotations) {
  const bool has_title = !plan.title.empty() && plan.title != annotations.mission;
  const std::string title = has_title ? plan.title : "Floor plan";
  const double width = cell.width() - 2.0 * kCompassRadius_mm;  // but for the line below it
  const auto add_row = [&](int line, const std::string& text, const TextStyle& style) {
    add_text(group, {cell.left(), cell.baseline(line) + (line > 0 ? 0.6 : 0.0)},
             shortened(text, line < 4 ? width : cell.width(), style.size_mm, style.weight), style);
  };
  add_row(0, title, {4.2, Weight::bold, Anchor::start, kInk});
  int line = 1;
  if (!annotations.mission.empty()) {
    add_row(line++, "Mission " + annotations.mission, {kText_mm, Weight::normal, {}, kInk});
  }
  if (!annotations.date.empty()) {
    add_row(line++, "Recorded " + annotations.date, {kText_mm, Weight::normal, {}, kInk});
  }
  add_row(4, "Measured by a robot. Not a survey.", {2.1, Weight::normal, {}, kFaintInk});
}

/// Two digits that mean something, no more.
std::string accuracy_text(double accuracy_m) {
  return "\u00b1\u00a0" + fixed(accuracy_m, accuracy_m < 1.0 ? 2 : 1) + "\u00a0m";
}

void add_facts(pugi::xml_node group, const Cell& cell, const FloorPlan& plan,
               const PlanAnnotations& annotations) {
  double area_m2 = 0.0;
  for (const PlanRoom& room : plan.rooms) area_m2 += room.area_m2;
  std::vector<std::pair<std::string, std::string>> rows = {
      {"Rooms", std::to_string(plan.rooms.size())},
      {"Doors", std::to_string(plan.doors.size())},
      {"Floor area", area_text(area_m2)}};
  if (annotations.path_length_m > 0.0) {
    rows.emplace_back("Path driven", fixed(annotations.path_length_m, 0) + "\u00a0m");
  }
  if (annotations.accuracy_m) {
    rows.emplace_back("Estimated accuracy", accuracy_text(*annotations.accuracy_m));
  }
  int line = 0;
  for (const auto& [name, value] : rows) {
    add_text(group, {cell.left(), cell.baseline(line)}, name,
             {kText_mm, Weight::normal, Anchor::start, kFaintInk});
    add_text(group, {cell.left() + cell.width(), cell.baseline(line)}, value,
             {kText_mm, Weight::bold, Anchor::end, kInk});
    ++line;
  }
}

/// One kind of thing on the sheet, as a swatch or a line.
struct LegendEntry {
  std::string name;
  Attributes swatch;  ///< of a rectangle; empty for a line
  Attributes line;
};

std::vector<LegendEntry> legend_of(const FloorPlan& plan, bool has_unexplored,
                                   const DrawOptions& options) {
  std::vector<LegendEntry> entries;
  const Attributes outline = {{"stroke", kFaintInk}, {"stroke-width", kHairline_mm}};
  const auto add_swatch = [&](const std::string& name, const char* fill) {
    Attributes swatch = outline;
    swatch.emplace_back("fill", fill);
    entries.push_back({name, swatch, {}});
  };
  for (const RoomKind kind : {RoomKind::room, RoomKind::corridor, RoomKind::hall}) {
    if (std::any_of(plan.rooms.begin(), plan.rooms.end(),
                    [&](const PlanRoom& room) { return room.kind == kind; })) {
      add_swatch(to_string(kind), tint(kind));
    }
  }
  if (!plan.walls.empty()) add_swatch("wall", kWallFill);
  if (!plan.doors.empty()) add_swatch("door", kDoorFill);
  if (!plan.furniture.empty()) add_swatch("furniture", kFurnitureFill);
  if (has_unexplored) {
    entries.push_back({"unexplored",
                       {},
                       {{"stroke", kUnexploredStroke},
                        {"stroke-width", kFrame_mm},
                        {"stroke-dasharray", kUnexploredDash}}});
  }
  if (options.show_trajectory) {
    entries.push_back({"path", {}, {{"stroke", kPathStroke}, {"stroke-width", kFrame_mm}}});
  }
  if (options.show_room_graph) {
    entries.push_back(
        {"room graph",
         {},
         {{"stroke", kGraphStroke}, {"stroke-width", kFrame_mm}, {"stroke-dasharray", "1.2 0.8"}}});
  }
  if (options.show_corrections) {
    entries.push_back(
        {"correction", {}, {{"stroke", kCorrectionStroke}, {"stroke-width", kFrame_mm}}});
  }
  if (options.show_uncertainty) {
    entries.push_back(
        {"95 % sure", {}, {{"stroke", kUncertaintyStroke}, {"stroke-width", kFrame_mm}}});
  }
  return entries;
}

void add_legend(pugi::xml_node parent, const Cell& cell, const std::vector<LegendEntry>& entries) {
  constexpr double kSwatch_mm = 4.5;  // width of a sample in the legend
  const int count = static_cast<int>(entries.size());
  const int rows = std::max(5, (count + 1) / 2);  // of two columns
  const double pitch_mm = 5.0 * kLine_mm / rows;
  pugi::xml_node group = add_group(parent, "legend");
  for (int i = 0; i < count; ++i) {
    const LegendEntry& entry = entries[static_cast<std::size_t>(i)];
    const double x = cell.left() + (i / rows) * cell.width() / 2.0;
    const double baseline = cell.baseline(0) + (i % rows) * pitch_mm;
    const Box2 box{{x, baseline - 2.3}, {x + kSwatch_mm, baseline + 0.5}};
    if (entry.line.empty()) {
      add_rectangle(group, box, entry.swatch);
    } else {
      const double middle = (box.min.y() + box.max.y()) / 2.0;
      add_line(group, {box.min.x(), middle}, {box.max.x(), middle}, entry.line);
    }
    add_text(group, {x + kSwatch_mm + 1.5, baseline}, entry.name, {kText_mm, {}, {}, kInk});
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

void add_title_block(pugi::xml_node svg, const FloorPlan& plan, const PlanAnnotations& annotations,
                     const DrawOptions& options, const Sheet& sheet) {
  pugi::xml_node group = add_layer(svg, "title");
  const Attributes frame = {{"fill", "none"}, {"stroke", kInk}, {"stroke-width", kFrame_mm}};
  add_rectangle(group, sheet.strip_mm, frame);
  const auto cells = cells_of(sheet.strip_mm);
  for (std::size_t i = 1; i < cells.size(); ++i) {
    add_line(group, cells[i].box.min, {cells[i].box.min.x(), cells[i].box.max.y()},
             {{"stroke", kInk}, {"stroke-width", kHairline_mm}});
  }
  add_heading(group, cells[0], plan, annotations);
  add_compass(group,
              {cells[0].box.max.x() - kCompassRadius_mm - 1.5,
               cells[0].box.min.y() + kCompassRadius_mm + 1.5},
              options.north_deg);
  add_facts(group, cells[1], plan, annotations);
  add_legend(group, cells[2], legend_of(plan, !annotations.unexplored.empty(), options));
  const Cell& last = cells[3];
  add_text(group, {last.left(), last.baseline(0)}, "Scale", {kText_mm, {}, {}, kFaintInk});
  add_text(group, {last.left() + last.width(), last.baseline(0)},
           "1\u2009:\u2009" + std::to_string(sheet.scale),
           {kText_mm, Weight::bold, Anchor::end, kInk});
  add_text(group, {last.left(), last.baseline(1)}, "Paper", {kText_mm, {}, {}, kFaintInk});
  add_text(group, {last.left() + last.width(), last.baseline(1)}, sheet.paper,
           {kText_mm, {}, Anchor::end, kInk});
  add_scale_bar(group, {last.left() + 1.0, last.box.min.y() + 18.0}, last.width() - 6.0,
                sheet.to_paper.mm_per_m);
}

}  // namespace roomatlas::drawing
