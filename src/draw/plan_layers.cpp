// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_layers.hpp"

#include "style.hpp"
#include "svg.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas::drawing {
namespace {

constexpr double kNodeRadius_mm = 0.8;  // of a room in the graph

/// The middle of a door between the two rooms, so that the edge runs through it.
std::optional<Point2> door_between(const FloorPlan& plan, RoomId first, RoomId second) {
  const auto [low, high] = std::minmax(first, second);
  for (const PlanDoor& door : plan.doors) {
    if (door.room_a == low && door.room_b == high) return (door.jambs.a + door.jambs.b) / 2.0;
  }
  return std::nullopt;
}

constexpr const char* kDoubtfulOpacity = "0.3";  // of a room's tint

}  // namespace

void add_rooms(pugi::xml_node svg, const FloorPlan& plan, const std::set<RoomId>& doubtful,
               const Sheet& sheet) {
  pugi::xml_node group = add_layer(svg, "rooms", true,
                                   {{"fill-rule", "evenodd"},
                                    {"stroke", kWallFill},
                                    {"stroke-width", number(line_weights(sheet.scale).fine)},
                                    {"stroke-linejoin", "round"}});
  for (const PlanRoom& room : plan.rooms) {
    pugi::xml_node path = add(group, "path",
                              {{"id", "room-" + std::to_string(room.id)},
                               {"class", to_string(room.kind)},
                               {"data-room", std::to_string(room.id)},
                               {"data-area-m2", fixed(room.area_m2, 3)},
                               {"fill", tint(room.kind)},
                               {"d", path_of(sheet.to_paper(room.parts))}});
    if (doubtful.contains(room.id)) path.append_attribute("fill-opacity") = kDoubtfulOpacity;
    add_title(path, room.name + ", " + to_string(room.kind) + ", " + area_text(room.area_m2));
  }
}

void add_room_graph(pugi::xml_node svg, const FloorPlan& plan,
                    const std::vector<std::pair<RoomId, RoomId>>& edges, bool is_shown,
                    const Sheet& sheet) {
  pugi::xml_node group = add_layer(
      svg, "room-graph", is_shown,
      {{"fill", "none"}, {"stroke", kGraphStroke}, {"stroke-width", "0.35"}, {"opacity", "0.55"}});
  for (const auto& [first, second] : edges) {
    const PlanRoom* a = find_room(plan, first);
    const PlanRoom* b = find_room(plan, second);
    if (a == nullptr || b == nullptr) continue;
    Polyline line = {sheet.to_paper(a->label_point)};
    if (const auto door = door_between(plan, first, second)) line.push_back(sheet.to_paper(*door));
    line.push_back(sheet.to_paper(b->label_point));
    add(group, "path", {{"d", path_of(line)}, {"stroke-dasharray", "1.2 0.8"}});
  }
  for (const PlanRoom& room : plan.rooms) {
    const Point2 at = sheet.to_paper(room.label_point);
    add(group, "circle",
        {{"data-room", std::to_string(room.id)},
         {"cx", number(at.x())},
         {"cy", number(at.y())},
         {"r", number(kNodeRadius_mm)},
         {"fill", kGraphStroke}});
  }
}

std::vector<Box2> graph_nodes(const FloorPlan& plan, const Sheet& sheet) {
  const Point2 half = Point2::Constant(kNodeRadius_mm + 0.2);
  std::vector<Box2> boxes;
  for (const PlanRoom& room : plan.rooms) {
    const Point2 at = sheet.to_paper(room.label_point);
    boxes.push_back({at - half, at + half});
  }
  return boxes;
}

}  // namespace roomatlas::drawing
