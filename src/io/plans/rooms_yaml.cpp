// SPDX-License-Identifier: GPL-3.0-or-later
#include "geojson_geometry.hpp"
#include "roomatlas/io/plans/room_tables.hpp"
#include "text/json.hpp"

namespace roomatlas {
namespace {

/// A double-quoted YAML text; JSON's escapes are YAML's too.
std::string quoted(const std::string& text) { return compact(text); }

std::string flow(const Point2& point) { return to_json(point).dump(); }

std::string flow(const Ring& ring) {
  Json points = Json::array();
  for (const Point2& point : ring) points.push_back(to_json(point));
  return points.dump();
}

std::string id_or_null(const std::optional<RoomId>& id) {
  return id ? std::to_string(*id) : "null";
}

}  // namespace

std::string rooms_yaml(const FloorPlan& plan) {
  std::string text = "# metres in the frame of map.yaml; polygons are outer outlines\n";
  text += plan.rooms.empty() ? "rooms: []\n" : "rooms:\n";
  for (const PlanRoom& room : plan.rooms) {
    text += "  - id: " + std::to_string(room.id) + "\n    name: " + quoted(room.name) +
            "\n    kind: " + to_string(room.kind) +
            "\n    area_m2: " + Json(to_millimetre(room.area_m2)).dump() +
            "\n    goal: " + flow(room.label_point) + "\n";
    text += room.parts.empty() ? "    polygons: []\n" : "    polygons:\n";
    for (const Polygon& part : room.parts) text += "      - " + flow(part.outer) + "\n";
  }
  text += plan.doors.empty() ? "doors: []\n" : "doors:\n";
  for (const PlanDoor& door : plan.doors) {
    text += "  - id: " + std::to_string(door.id) +
            "\n    at: " + flow(Point2((door.jambs.a + door.jambs.b) / 2.0)) +
            "\n    width_m: " + Json(to_millimetre(door.width_m)).dump() + "\n    rooms: [" +
            id_or_null(door.room_a) + ", " + id_or_null(door.room_b) + "]\n";
  }
  return text;
}

}  // namespace roomatlas
