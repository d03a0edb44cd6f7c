// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "room_labels.hpp"
#include "sheet.hpp"

#include "roomatlas/draw/draw.hpp"

#include <pugixml.hpp>

#include <vector>

/// The layers of a plan, each a group with a stable id.
namespace roomatlas::drawing {

void add_rooms(pugi::xml_node svg, const FloorPlan& plan, const Sheet& sheet);
void add_furniture(pugi::xml_node svg, const FloorPlan& plan, const Sheet& sheet);
void add_walls(pugi::xml_node svg, const FloorPlan& plan, const Sheet& sheet);
void add_doors(pugi::xml_node svg, const FloorPlan& plan, const Sheet& sheet);
/// Empty unless wanted.
void add_trajectory(pugi::xml_node svg, const Polyline& trajectory, bool is_wanted,
                    const Sheet& sheet);
void add_room_graph(pugi::xml_node svg, const FloorPlan& plan,
                    const std::vector<std::pair<RoomId, RoomId>>& edges, bool is_wanted,
                    const Sheet& sheet);
/// What labels have to keep clear of when the graph is drawn.
[[nodiscard]] std::vector<Box2> graph_nodes(const FloorPlan& plan, const Sheet& sheet);
/// @param has_halo for a drawing with lines under the labels.
void add_labels(pugi::xml_node svg, const std::vector<RoomLabel>& labels, bool has_halo);
/// The overall width and height, with dimension lines.
void add_dimensions(pugi::xml_node svg, const Box2& building_m, const Sheet& sheet);

}  // namespace roomatlas::drawing
