// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/room_tables.hpp"
#include "roomatlas/draw/markup_text.hpp"

#include <algorithm>
#include <cstdio>
#include <map>

namespace roomatlas {
namespace {

std::string fixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value + 0.0);
  return text;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

/// How many doors each room has.
std::map<RoomId, int> door_counts(const FloorPlan& plan) {
  std::map<RoomId, int> counts;
  for (const PlanDoor& door : plan.doors) {
    if (door.room_a) ++counts[*door.room_a];
    if (door.room_b && door.room_b != door.room_a) ++counts[*door.room_b];
  }
  return counts;
}

std::string data(const char* key, const std::string& value) {
  return std::string("<data key=\"") + key + "\">" + markup_text(value) + "</data>";
}

constexpr const char* kGraphmlHead = R"(<?xml version="1.0" encoding="UTF-8"?>
<graphml xmlns="http://graphml.graphdrawing.org/xmlns" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:schemaLocation="http://graphml.graphdrawing.org/xmlns http://graphml.graphdrawing.org/xmlns/1.0/graphml.xsd">
<key id="name" for="node" attr.name="name" attr.type="string"/>
<key id="kind" for="node" attr.name="kind" attr.type="string"/>
<key id="area_m2" for="node" attr.name="area_m2" attr.type="double"/>
<key id="x_m" for="node" attr.name="x_m" attr.type="double"/>
<key id="y_m" for="node" attr.name="y_m" attr.type="double"/>
<key id="width_m" for="edge" attr.name="width_m" attr.type="double"/>
<graph id="rooms" edgedefault="undirected">
)";

}  // namespace

std::string rooms_csv(const FloorPlan& plan) {
  std::map<RoomId, int> doors = door_counts(plan);
  std::string text = "id,name,kind,area_m2,doors\r\n";
  for (const PlanRoom& room : plan.rooms) {
    text += std::to_string(room.id) + ',' + csv_field(room.name) + ',' + to_string(room.kind) +
            ',' + fixed(room.area_m2, 2) + ',' + std::to_string(doors[room.id]) + "\r\n";
  }
  return text;
}

std::string rooms_graphml(const FloorPlan& plan) {
  const auto has = [&](const std::optional<RoomId>& id) { return id && has_room(plan, *id); };
  std::string text = kGraphmlHead;
  for (const PlanRoom& room : plan.rooms) {
    text += "<node id=\"r" + std::to_string(room.id) + "\">" + data("name", room.name) +
            data("kind", to_string(room.kind)) + data("area_m2", fixed(room.area_m2, 3)) +
            data("x_m", fixed(room.label_point.x(), 3)) +
            data("y_m", fixed(room.label_point.y(), 3)) + "</node>\n";
  }
  for (const PlanDoor& door : plan.doors) {
    if (!has(door.room_a) || !has(door.room_b)) continue;
    text += "<edge id=\"d" + std::to_string(door.id) + "\" source=\"r" +
            std::to_string(*door.room_a) + "\" target=\"r" + std::to_string(*door.room_b) + "\">" +
            data("width_m", fixed(door.width_m, 3)) + "</edge>\n";
  }
  return text + "</graph>\n</graphml>\n";
}

}  // namespace roomatlas
