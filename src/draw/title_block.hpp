// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sheet.hpp"

#include "roomatlas/draw/draw.hpp"

#include <pugixml.hpp>

namespace roomatlas::drawing {

/// The strip along the lower edge: what the sheet shows, measures, legend and scale.
void add_title_block(pugi::xml_node svg, const FloorPlan& plan, const PlanAnnotations& annotations,
                     const DrawOptions& options, const Sheet& sheet);

/// A bar of a round length with its figures, from `at` (its upper left corner) to the right.
void add_scale_bar(pugi::xml_node parent, const Point2& at, double longest_mm, double mm_per_m);

}  // namespace roomatlas::drawing
