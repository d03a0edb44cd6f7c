// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

/// The rooms as a table, RFC 4180 with a header line: `id,name,kind,area_m2,doors`, where `doors`
/// is their number. Areas in m^2 with two decimals; lines end with CR LF. A name that a
/// spreadsheet would take for a formula (it begins with = + - or @) is written as it is.
[[nodiscard]] std::string rooms_csv(const FloorPlan& plan);

/// The graph of rooms as GraphML: a node `r1` for each room with its name, kind, area and label
/// point, an undirected edge `d1` for each door between two rooms of the plan, with its width. A
/// door that leads to an unknown room has no edge.
[[nodiscard]] std::string rooms_graphml(const FloorPlan& plan);

/// The rooms for robots, as YAML: names, kinds, areas, a goal well inside, outlines, and the doors
/// with their middles, widths and rooms; metres in the frame of the nav2 map beside it.
[[nodiscard]] std::string rooms_yaml(const FloorPlan& plan);

}  // namespace roomatlas
