// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_layers.hpp"
#include "style.hpp"
#include "svg.hpp"

#include <algorithm>

namespace roomatlas::drawing {
namespace {

constexpr double kBlank_m = 0.35;   // covers a wall that was assumed
constexpr double kSharpest = 0.35;  // of a corner: the cosine of half its turn

Point2 right_of(const Point2& direction) { return {direction.y(), -direction.x()}; }

/// The line moved to its right; corners stay corners unless they are very sharp.
Polyline moved_right(const Polyline& line, double distance_m) {
  Polyline moved;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Point2 before = (line[i] - line[i == 0 ? 0 : i - 1]).normalized();
    const Point2 after = (line[i + 1 == line.size() ? i : i + 1] - line[i]).normalized();
    const Point2 sum = right_of(before) + right_of(after);
    const Point2 middle = sum.normalized();
    const bool is_end = i == 0 || i + 1 == line.size();
    const double cosine = is_end ? 1.0 : std::max(kSharpest, middle.dot(right_of(after)));
    moved.push_back(line[i] + middle * (distance_m / cosine));
  }
  return moved;
}

}  // namespace

void add_unexplored(pugi::xml_node svg, const std::vector<Polyline>& lines, bool is_wall_blank,
                    const Sheet& sheet) {
  pugi::xml_node layer = add_layer(svg, "unexplored");
  pugi::xml_node blanks = add(layer, "g", {{"fill", "#ffffff"}});
  pugi::xml_node limits = add(layer, "g",
                              {{"fill", "none"},
                               {"stroke", kUnexploredStroke},
                               {"stroke-width", kFrame_mm},
                               {"stroke-dasharray", kUnexploredDash}});
  for (const Polyline& line : lines) {
    if (line.size() < 2) continue;
    if (!is_wall_blank) {
      const Polyline outside = moved_right(line, kBlank_m);
      Ring blank = line;
      blank.insert(blank.end(), outside.rbegin(), outside.rend());
      const std::string outline = path_of({{sheet.to_paper(blank), {}}});
      // A little over the edge of the room, whose line would shine through the dashes.
      add(blanks, "path",
          {{"d", outline},
           {"stroke", "#ffffff"},
           {"stroke-width", number(line_weights(sheet.scale).cut + 0.1)}});
    }
    add(limits, "path", {{"class", "unexplored"}, {"d", path_of(sheet.to_paper(line))}});
  }
}

}  // namespace roomatlas::drawing
