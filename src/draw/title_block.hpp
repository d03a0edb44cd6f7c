// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sheet.hpp"

#include "roomatlas/draw/draw.hpp"

#include "legend.hpp"

#include <pugixml.hpp>

#include <optional>
#include <string>
#include <vector>

namespace roomatlas::drawing {

/// A name and what is said of it; alone where there is nothing to be said.
struct Fact {
  std::string name;
  std::string value;
};

/// What stands in the strip along the lower edge, beside scale and paper.
struct TitleStrip {
  std::string title;
  std::vector<std::string> lines;  ///< below it, three at most
  std::vector<Fact> facts;
  std::vector<LegendEntry> legend;
  std::optional<double> north_deg;  ///< see `add_compass`
};
void add_title_strip(pugi::xml_node svg, const TitleStrip& strip, const Sheet& sheet);

/// The strip along the lower edge: what the sheet shows, measures, legend and scale.
void add_title_block(pugi::xml_node svg, const FloorPlan& plan, const PlanAnnotations& annotations,
                     const DrawOptions& options, const Sheet& sheet);

/// A bar of a round length with its figures, from `at` (its upper left corner) to the right.
void add_scale_bar(pugi::xml_node parent, const Point2& at, double longest_mm, double mm_per_m);

}  // namespace roomatlas::drawing
