// SPDX-License-Identifier: GPL-3.0-or-later
#include "geojson_geometry.hpp"
#include "plan_schema.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/files/input_file.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "text/json.hpp"
#include "text/parse_json.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace roomatlas {
namespace {

Json parse(const Path& file) { return io::parse_json(read_text_file(file), file.string()); }

std::string read_header(const JsonField& document) {
  const JsonField type = document.at("type");
  if (type.text() != "FeatureCollection") type.fail("\"FeatureCollection\"");
  const JsonField header = document.at("roomatlas");
  const JsonField schema = header.at("schema");
  if (schema.text() != plan_schema::kSchema) schema.fail("\"plan\"");
  const JsonField version = header.at("version");
  if (version.positive_integer() != plan_schema::kVersion) version.fail("version 1");
  const JsonField units = header.at("units");
  if (units.text() != plan_schema::kUnits) units.fail("\"m\": convert the coordinates to metres");
  const auto title = header.find("title");
  return title ? title->text() : std::string();
}

std::optional<RoomKind> room_kind(const std::string& word) {
  for (const auto& entry : plan_schema::kRoomWords) {
    if (word == entry.word) return entry.kind;
  }
  return std::nullopt;
}

double area_of(const std::vector<Polygon>& parts) {
  double sum_m2 = 0.0;
  for (const Polygon& part : parts) sum_m2 += area(part);
  return sum_m2;
}

Point2 default_label(const std::vector<Polygon>& parts) {
  const auto largest =
      std::max_element(parts.begin(), parts.end(),
                       [](const Polygon& a, const Polygon& b) { return area(a) < area(b); });
  return largest == parts.end() ? Point2(Point2::Zero()) : label_point_in(*largest);
}

PlanRoom read_room(const JsonField& properties, const JsonField& geometry, RoomKind kind) {
  PlanRoom room;
  room.kind = kind;
  room.id = properties.at("id").positive_integer();
  const auto name = properties.find("name");
  room.name = name ? name->text() : std::to_string(room.id);
  room.parts = read_polygons(geometry);
  const auto area_m2 = properties.find("area_m2");
  room.area_m2 = area_m2 ? area_m2->number_not_negative() : area_of(room.parts);
  const auto label = properties.find("label");
  room.label_point = label ? read_position(*label) : default_label(room.parts);
  if (const auto asrs = properties.find("asrs")) {
    for (std::size_t i = 0; i < asrs->size(); ++i) {
      room.asrs.push_back(asrs->element(i).positive_integer());
    }
  }
  return room;
}

void read_rooms(const JsonField& rooms, PlanDoor& door) {
  if (rooms.size() != 2) rooms.fail("null or two room ids");
  const auto id = [&](std::size_t side) -> std::optional<RoomId> {
    if (rooms.element(side).is_null()) return std::nullopt;
    return rooms.element(side).positive_integer();
  };
  door.room_a = id(0);
  door.room_b = id(1);
  if (!door.room_a || !door.room_b) return;
  if (*door.room_a == *door.room_b) rooms.fail("two different rooms");
  if (*door.room_a > *door.room_b) std::swap(door.room_a, door.room_b);
}

Segment2 read_line(const JsonField& positions) {
  if (positions.size() != 2) positions.fail("two positions");
  return {read_position(positions.element(0)), read_position(positions.element(1))};
}

DoorKind read_opening(const JsonField& opening) {
  const std::string word = opening.text();
  for (const DoorKind kind : {DoorKind::door, DoorKind::passage, DoorKind::window}) {
    if (word == to_string(kind)) return kind;
  }
  opening.fail("\"door\", \"passage\" or \"window\"");
}

FurnitureKind read_furniture_kind(const JsonField& furniture) {
  const std::string word = furniture.text();
  for (const FurnitureKind kind : {FurnitureKind::against_wall, FurnitureKind::free_standing}) {
    if (word == to_string(kind)) return kind;
  }
  furniture.fail("\"against_wall\" or \"free_standing\"");
}

PlanFurniture read_furniture(const JsonField& properties, const JsonField& geometry) {
  PlanFurniture piece{read_polygon(geometry), FurnitureKind::free_standing};
  if (const auto kind = properties.find("furniture")) piece.kind = read_furniture_kind(*kind);
  return piece;
}

PlanDoor read_door(const JsonField& properties, const JsonField& geometry) {
  PlanDoor door;
  door.id = properties.at("id").positive_integer();
  door.jambs = read_line(properties.at("jambs"));
  const auto width_m = properties.find("width_m");
  door.width_m = width_m ? width_m->number_not_negative() : (door.jambs.b - door.jambs.a).norm();
  if (const auto rooms = properties.find("rooms")) read_rooms(*rooms, door);
  if (const auto opening = properties.find("opening")) door.kind = read_opening(*opening);
  if (const auto leaf = properties.find("leaf")) door.leaf = read_line(*leaf);
  if (!geometry.is_null()) door.opening = read_polygon(geometry).outer;
  return door;
}

PlanEdge read_edge(const JsonField& properties, const JsonField& geometry) {
  PlanEdge edge;
  edge.room = properties.at("room").positive_integer();
  edge.line = read_segment(geometry);
  const JsonField evidence = properties.at("evidence");
  const std::string word = evidence.text();
  bool is_known = false;
  for (const WallEvidence one :
       {WallEvidence::measured, WallEvidence::inferred, WallEvidence::unexplored}) {
    if (word != to_string(one)) continue;
    edge.evidence = one;
    is_known = true;
  }
  if (!is_known) evidence.fail("\"measured\", \"inferred\" or \"unexplored\"");
  if (const auto deviation_m = properties.find("deviation_m")) {
    edge.deviation_m = deviation_m->number_not_negative();
  }
  return edge;
}

void read_feature(const JsonField& feature, FloorPlan& plan) {
  const JsonField type = feature.at("type");
  if (type.text() != "Feature") type.fail("\"Feature\"");
  const JsonField properties = feature.at("properties");
  const JsonField geometry = feature.at("geometry");
  const JsonField kind = properties.at("kind");
  const std::string word = kind.text();
  if (const auto room = room_kind(word)) {
    plan.rooms.push_back(read_room(properties, geometry, *room));
  } else if (word == "door") {
    plan.doors.push_back(read_door(properties, geometry));
  } else if (word == "wall") {
    plan.walls.push_back(read_polygon(geometry));
  } else if (word == "furniture") {
    plan.furniture.push_back(read_furniture(properties, geometry));
  } else if (word == "edge") {
    plan.edges.push_back(read_edge(properties, geometry));
  } else {
    kind.fail("\"room\", \"corridor\", \"hall\", \"door\", \"wall\", \"furniture\" or \"edge\"");
  }
}

/// Ids are unique, and doors lead to rooms that exist.
void check_ids(const FloorPlan& plan, const Path& file) {
  const auto fail = [&](const std::string& what) { throw InputError(file.string() + ": " + what); };
  std::set<RoomId> rooms;
  for (const PlanRoom& room : plan.rooms) {
    if (!rooms.insert(room.id).second) fail("two rooms have the id " + std::to_string(room.id));
  }
  for (const PlanEdge& edge : plan.edges) {
    if (!rooms.contains(edge.room)) {
      fail("an edge is of room " + std::to_string(edge.room) + ", which is not in the file");
    }
  }
  std::set<std::int64_t> doors;
  for (const PlanDoor& door : plan.doors) {
    const std::string name = "door " + std::to_string(door.id);
    if (!doors.insert(door.id).second) fail("two doors have the id " + std::to_string(door.id));
    for (const auto& room : {door.room_a, door.room_b}) {
      if (room && !rooms.contains(*room)) {
        fail(name + " leads to room " + std::to_string(*room) + ", which is not in the file");
      }
    }
  }
}

}  // namespace

FloorPlan read_plan(const Path& file) {
  const Json json = parse(file);
  const JsonField document(json, file.string(), "");
  FloorPlan plan;
  plan.title = read_header(document);
  const JsonField features = document.at("features");
  for (std::size_t i = 0; i < features.size(); ++i) read_feature(features.element(i), plan);
  check_ids(plan, file);
  return plan;
}

}  // namespace roomatlas
