// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draw/draw.hpp"

#include "sheet.hpp"
#include "style.hpp"
#include "svg.hpp"
#include "title_block.hpp"

#include <algorithm>
#include <map>

namespace roomatlas {
namespace {

using namespace drawing;

// Sizes on the page.
constexpr double kGutter_mm = 5.0;
constexpr double kTitle_mm = 9.0;
constexpr double kCaption_mm = 10.0;
constexpr double kFooter_mm = 12.0;
constexpr double kTallestPanel_mm = 120.0;
constexpr double kPanelWidth_mm =  // three in a row
    (kComparison_mm - 2.0 * kComparisonEdge_mm - 2.0 * kGutter_mm) / 3.0;
constexpr const char* kPointStroke = "#0072b2";

/// What is not unknown of a grid, in metres.
Box2 seen_part(const HimmGrid& grid) {
  Box2 seen;
  const double cell_m = grid.frame().cell_m;
  for_each_cell(grid.box(), [&](const Cell& cell) {
    if (grid.raw(cell) == 0) return;
    seen.extend(cell_m * Point2(cell.x, cell.y));
    seen.extend(cell_m * Point2(cell.x + 1, cell.y + 1));
  });
  return seen;
}

struct Panel {
  pugi::xml_node group;
  Point2 lower_left_mm;
  PaperTransform to_paper;
};

/// Where the panels stand and how large they show the room.
class Layout {
 public:
  explicit Layout(const Box2& room_m) : room_m_(room_m) {
    const Point2 size_m = room_m.size().cwiseMax(Point2::Constant(0.1));
    scale_ = fine_scale(kMillimetres *
                        std::max(size_m.x() / kPanelWidth_mm, size_m.y() / kTallestPanel_mm));
    height_mm_ = size_m.y() * kMillimetres / scale_;
  }

  [[nodiscard]] int scale() const { return scale_; }
  [[nodiscard]] double mm_per_m() const { return kMillimetres / scale_; }
  [[nodiscard]] double row_mm() const { return kCaption_mm + height_mm_; }
  [[nodiscard]] double bottom_mm() const { return kComparisonEdge_mm + kTitle_mm + 2.0 * row_mm(); }

  [[nodiscard]] Panel add(pugi::xml_node svg, int number, const char* id,
                          const std::string& caption, const std::string& counts) const {
    const double left = kComparisonEdge_mm + (number % 3) * (kPanelWidth_mm + kGutter_mm);
    const int row = number / 3;
    const double top = kComparisonEdge_mm + kTitle_mm + row * row_mm() + kCaption_mm - 3.0;
    pugi::xml_node group = add_group(svg, id);
    const std::string letter(1, static_cast<char>('a' + number));
    add_text(group, {left, top - 4.6}, letter + "  " + caption,
             {3.2, Weight::bold, Anchor::start, kInk});
    add_text(group, {left, top - 1.4}, counts, {2.5, Weight::normal, Anchor::start, kFaintInk});
    const Point2 corner(left, top + height_mm_);
    return {
        group,
        corner,
        {mm_per_m(),
         {corner.x() - mm_per_m() * room_m_.min.x(), corner.y() + mm_per_m() * room_m_.min.y()}}};
  }

 private:
  Box2 room_m_;
  int scale_ = 50;  ///< 1 to this
  double height_mm_ = 0.0;
};

/// Cells of one colour as one path: runs along rows.
class CellPainter {
 public:
  explicit CellPainter(const CellFrame& frame) : frame_(frame) {}

  template <typename Colour>
  void paint(const Panel& panel, const CellBox& box, Colour colour_of) const {
    std::map<std::string, std::string> paths;
    for (int y = box.min.y; y < box.max.y; ++y) {
      for (int x = box.min.x; x < box.max.x;) {
        const std::string colour = colour_of(Cell{x, y});
        int end = x + 1;
        while (end < box.max.x && colour_of(Cell{end, y}) == colour) ++end;
        if (!colour.empty()) paths[colour] += run(panel, x, end, y);
        x = end;
      }
    }
    for (const auto& [colour, path] : paths) {
      add(panel.group, "path", {{"fill", colour}, {"d", path}});
    }
  }

 private:
  [[nodiscard]] std::string run(const Panel& panel, int from, int to, int y) const {
    const double cell_m = frame_.cell_m;
    const Point2 low = panel.to_paper(Point2(cell_m * Point2(from, y)));
    const Point2 high = panel.to_paper(Point2(cell_m * Point2(to, y + 1)));
    return "M" + number(low.x()) + " " + number(low.y()) + "H" + number(high.x()) + "V" +
           number(high.y()) + "H" + number(low.x()) + "Z";
  }

  CellFrame frame_;
};

/// Darker for more certainty, a tint for free floor, nothing for unknown.
std::string himm_colour(const HimmGrid& grid, const Cell& cell) {
  const double value = grid.value(cell);
  if (grid.is_robot_path(cell)) return "#dbe7f3";
  if (value < 0.0) return "#f3f6f9";
  if (value == 0.0) return "";
  static const char* const kShades[] = {"#d9d9d9", "#b8b8b8", "#8f8f8f", "#636363", "#1f2933"};
  return kShades[std::min(4, static_cast<int>(value / 3.01))];
}

std::string cleaned_colour(CellState state) {
  switch (state) {
    case CellState::occupied:
      return kInk;
    case CellState::robot_path:
      return "#dbe7f3";
    case CellState::empty:
      return "#f3f6f9";
    case CellState::unknown:
      break;
  }
  return "";
}

void add_lines(const Panel& panel, const std::vector<Polyline>& lines, const char* stroke,
               const char* width) {
  std::string path;
  for (const Polyline& line : lines) path += path_of(panel.to_paper(line));
  add(panel.group, "path",
      {{"fill", "none"},
       {"stroke", stroke},
       {"stroke-width", width},
       {"stroke-linejoin", "round"},
       {"d", path}});
}

void add_dots(const Panel& panel, const std::vector<Polyline>& lines, const char* fill,
              double radius_mm) {
  for (const Polyline& line : lines) {
    for (const Point2& point : line) {
      const Point2 at = panel.to_paper(point);
      add(panel.group, "circle",
          {{"cx", number(at.x())},
           {"cy", number(at.y())},
           {"r", number(radius_mm)},
           {"fill", fill}});
    }
  }
}

std::vector<Polyline> vertices_of(const std::vector<WallPolyline>& walls) {
  std::vector<Polyline> lines;
  lines.reserve(walls.size());
  for (const WallPolyline& wall : walls) lines.push_back(wall.vertices_asr);
  return lines;
}

std::string counted(std::int64_t count, const std::string& what) {
  return std::to_string(count) + " " + what;
}

std::int64_t size_of(const std::vector<Polyline>& lines) {
  std::int64_t count = 0;
  for (const Polyline& line : lines) count += std::ssize(line);
  return count;
}

}  // namespace

std::string draw_room_steps(const RoomMap& map, const Polyline& path, const std::string& title) {
  const Layout layout(seen_part(map.grid));
  pugi::xml_document document;
  pugi::xml_node svg = add_page(document, kComparison_mm, layout.bottom_mm() + kFooter_mm, title);
  add_text(svg, {kComparisonEdge_mm, kComparisonEdge_mm + 4.0}, title,
           {4.5, Weight::bold, Anchor::start, kInk});

  const AsrCounters& counters = map.counters;
  const CellPainter cells(map.grid.frame());
  const std::vector<Polyline> fitted = vertices_of(map.walls);

  const Panel raw = layout.add(svg, 0, "himm", "HIMM grid and path",
                               counted(counters.grid_cells, "cells, ") +
                                   counted(counters.occupied_cells, "of them occupied"));
  cells.paint(raw, map.grid.box(), [&](const Cell& cell) { return himm_colour(map.grid, cell); });
  add_lines(raw, {path}, kPathStroke, kThin_mm);

  const Panel cleaned =
      layout.add(svg, 1, "cleaned", "Cleaned", counted(counters.cleaned_cells, "cells occupied"));
  cells.paint(cleaned, map.cleaned.box,
              [&](const Cell& cell) { return cleaned_colour(map.cleaned.at(cell)); });
  add_lines(cleaned, {path}, kPathStroke, kThin_mm);

  const Panel points = layout.add(svg, 2, "points", "Points extracted, in order",
                                  counted(counters.extracted_points, "points in ") +
                                      counted(std::ssize(map.points), "polylines"));
  add_lines(points, map.points, "#b3bcc8", kThin_mm);
  add_dots(points, map.points, kPointStroke, 0.3);

  const Panel simplified = layout.add(svg, 3, "simplified", "Thinned, Douglas-Peucker",
                                      counted(size_of(map.simplified), "vertices"));
  add_lines(simplified, map.simplified, kPointStroke, kFrame_mm);
  add_dots(simplified, map.simplified, kPointStroke, 0.5);

  const Panel lines = layout.add(
      svg, 4, "fitted", "Lines fitted",
      counted(counters.vertices, "vertices, ") + counted(counters.geometry_bytes, "bytes"));
  add_lines(lines, fitted, kInk, kFrame_mm);
  add_dots(lines, fitted, kInk, 0.5);

  const Panel both = layout.add(svg, 5, "fit", "Before and after the fit",
                                "blue: Douglas-Peucker, orange: fitted, dots: points");
  add_dots(both, map.points, "#8f9baa", 0.25);
  add_lines(both, map.simplified, kPointStroke, kThin_mm);
  add_lines(both, fitted, kPathStroke, kThin_mm);

  add_scale_bar(svg, {kComparisonEdge_mm + 1.0, layout.bottom_mm() + 3.0}, 50.0, layout.mm_per_m());
  add_text(svg, {kComparison_mm - kComparisonEdge_mm, layout.bottom_mm() + 5.0},
           "1\u2009:\u2009" + std::to_string(layout.scale()),
           {2.6, Weight::normal, Anchor::end, kFaintInk});
  return to_text(document);
}

}  // namespace roomatlas
