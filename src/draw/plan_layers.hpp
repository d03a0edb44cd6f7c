// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "room_labels.hpp"
#include "sheet.hpp"

#include "roomatlas/draw/draw.hpp"

#include <pugixml.hpp>

#include <set>
#include <vector>

/// The layers of a plan, each a group with a stable id.
namespace roomatlas::drawing {

void add_rooms(pugi::xml_node svg, const FloorPlan& plan, const std::set<RoomId>& doubtful,
               const Sheet& sheet);
/// Thin outlines, hatched one way against walls and the other way where they stand free.
void add_furniture(pugi::xml_node svg, const FloorPlan& plan, const Sheet& sheet);
/// Solid where walls are thick, lighter where they are partitions.
void add_walls(pugi::xml_node svg, const FloorPlan& plan, const Sheet& sheet);
/// The inferred edges of rooms, dashed; walls that nobody measured without the solid fill.
void add_edges(pugi::xml_node svg, const FloorPlan& plan, const Sheet& sheet);
/// Doors with leaf and arc where the leaf was seen, else as openings; passages and windows.
void add_doors(pugi::xml_node svg, const FloorPlan& plan, const Sheet& sheet);
/// What a door's symbol covers on the sheet, its arc included.
[[nodiscard]] Box2 door_box(const PlanDoor& door, const Sheet& sheet);
/// The unexplored edges of a plan as lines with their room to the left.
[[nodiscard]] std::vector<Polyline> unexplored_lines(const FloorPlan& plan);
/// Takes away the wall that a plan assumes where nobody saw one, and dashes the limit instead.
/// @param lines with free space to their left, building metres
/// @param is_wall_blank `add_edges` has taken the wall away
void add_unexplored(pugi::xml_node svg, const std::vector<Polyline>& lines, bool is_wall_blank,
                    const Sheet& sheet);
void add_trajectory(pugi::xml_node svg, const Polyline& trajectory, bool is_shown,
                    const Sheet& sheet);
/// How the path of a mission is drawn: colours first, then dashes beside them.
struct PathStyle {
  const char* stroke;
  const char* dash;  ///< empty: solid
};
/// @param mission from 0; styles repeat after 24
[[nodiscard]] PathStyle path_style(std::size_t mission);
void add_mission_paths(pugi::xml_node svg, const std::vector<MissionPath>& missions, bool is_shown,
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
/// Chains of dimensions below and to the left of the building: over its walls, and overall.
void add_dimensions(pugi::xml_node svg, const FloorPlan& plan, const Sheet& sheet);

}  // namespace roomatlas::drawing
