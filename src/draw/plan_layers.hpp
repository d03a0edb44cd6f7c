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
/// Takes away the wall that a plan assumes where nobody saw one, and dashes the limit instead.
/// @param lines with free space to their left, building metres
void add_unexplored(pugi::xml_node svg, const std::vector<Polyline>& lines, const Sheet& sheet);
void add_trajectory(pugi::xml_node svg, const Polyline& trajectory, bool is_shown,
                    const Sheet& sheet);
void add_room_graph(pugi::xml_node svg, const FloorPlan& plan,
                    const std::vector<std::pair<RoomId, RoomId>>& edges, bool is_shown,
                    const Sheet& sheet);
/// An arrow for each correction that would be seen on paper.
void add_corrections(pugi::xml_node svg, const std::vector<Segment2>& corrections, bool is_shown,
                     const Sheet& sheet);
/// The ellipse that holds the place with a probability of 95 %.
void add_uncertainty(pugi::xml_node svg, const std::vector<UncertainPlace>& places, bool is_shown,
                     const Sheet& sheet);
/// What labels have to keep clear of when the graph is drawn.
[[nodiscard]] std::vector<Box2> graph_nodes(const FloorPlan& plan, const Sheet& sheet);
/// @param has_halo for a drawing with lines under the labels.
void add_labels(pugi::xml_node svg, const std::vector<RoomLabel>& labels, bool has_halo);
/// The clear width of each door beside it, where there is a place for it in a room.
void add_door_widths(pugi::xml_node svg, const FloorPlan& plan,
                     const std::vector<RoomLabel>& labels, const Sheet& sheet);
/// The overall width and height, with dimension lines.
void add_dimensions(pugi::xml_node svg, const Box2& building_m, const Sheet& sheet);

}  // namespace roomatlas::drawing
