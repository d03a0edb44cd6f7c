// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/draw/draw.hpp"

#include <pugixml.hpp>

#include <functional>
#include <string>
#include <vector>

namespace roomatlas::drawing {

/// One kind of thing on the sheet, with a sample of how it is drawn.
struct LegendEntry {
  std::string name;
  std::function<void(pugi::xml_node parent, const Box2& box)> draw;
};

/// What is on the plan, and no more: rooms, walls measured and inferred, openings, furniture, and
/// the layers that are shown.
[[nodiscard]] std::vector<LegendEntry> legend_of(const FloorPlan& plan,
                                                 const PlanAnnotations& annotations,
                                                 const DrawOptions& options, int scale);

/// In two columns, or three where the names allow.
void add_legend(pugi::xml_node parent, const Box2& box_mm, const std::vector<LegendEntry>& entries);

}  // namespace roomatlas::drawing
