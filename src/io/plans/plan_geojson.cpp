// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "geojson_geometry.hpp"
#include "plan_schema.hpp"
#include "text/json.hpp"

#include <algorithm>

namespace roomatlas {
namespace {

Json header_of(const FloorPlan& plan) {
  Json header;
  header["schema"] = plan_schema::kSchema;
  header["version"] = plan_schema::kVersion;
  header["units"] = plan_schema::kUnits;
  header["frame"] = plan_schema::kFrame;
  header["title"] = plan.title;
  return header;
}

Json feature_of(Json properties, Json geometry) {
  Json feature;
  feature["type"] = "Feature";
  feature["properties"] = std::move(properties);
  feature["geometry"] = std::move(geometry);
  return feature;
}

Json feature_of(const PlanRoom& room) {
  const auto word = std::find_if(plan_schema::kRoomWords.begin(), plan_schema::kRoomWords.end(),
                                 [&](const auto& entry) { return entry.kind == room.kind; });
  Json properties;
  properties["kind"] = word->word;
  properties["id"] = room.id;
  properties["name"] = room.name;
  properties["area_m2"] = to_millimetre(room.area_m2);
  properties["label"] = to_json(room.label_point);
  properties["asrs"] = room.asrs;
  properties["indoor"] = word->indoor;
  properties["ref"] = std::to_string(room.id);
  return feature_of(std::move(properties), to_geometry(room.parts));
}

Json rooms_of(const PlanDoor& door) {
  if (!door.room_a && !door.room_b) return nullptr;
  const auto id = [](const std::optional<RoomId>& room) {
    return room ? Json(*room) : Json(nullptr);
  };
  return Json::array({id(door.room_a), id(door.room_b)});
}

Json feature_of(const PlanDoor& door) {
  Json properties;
  properties["kind"] = "door";
  properties["id"] = door.id;
  properties["width_m"] = to_millimetre(door.width_m);
  properties["jambs"] = Json::array({to_json(door.jambs.a), to_json(door.jambs.b)});
  properties["rooms"] = rooms_of(door);
  if (door.kind != DoorKind::door) properties["opening"] = to_string(door.kind);
  if (door.leaf) {
    properties["leaf"] = Json::array({to_json(door.leaf->a), to_json(door.leaf->b)});
  }
  properties["indoor"] = "door";
  properties["ref"] = std::to_string(door.id);
  return feature_of(std::move(properties), to_geometry(door.opening));
}

/// A wall or a piece of furniture; a polygon of which rounding leaves nothing has no feature.
void append_body(const Polygon& polygon, Json properties, std::vector<Json>& features) {
  Json geometry = to_geometry(std::vector<Polygon>{polygon});
  if (geometry["coordinates"].empty()) return;
  features.push_back(feature_of(std::move(properties), std::move(geometry)));
}

Json properties_of(const PlanFurniture& piece) {
  Json properties = {{"kind", "furniture"}};
  if (piece.kind != FurnitureKind::free_standing) properties["furniture"] = to_string(piece.kind);
  return properties;
}

/// What speaks for the edges of rooms; one that rounding leaves no length has no feature.
void append_edges(const std::vector<PlanEdge>& edges, std::vector<Json>& features) {
  for (const PlanEdge& edge : edges) {
    Json geometry = to_geometry(edge.line);
    if (geometry.is_null()) continue;
    Json properties;
    properties["kind"] = "edge";
    properties["room"] = edge.room;
    properties["evidence"] = to_string(edge.evidence);
    if (edge.deviation_m) properties["deviation_m"] = to_millimetre(*edge.deviation_m);
    features.push_back(feature_of(std::move(properties), std::move(geometry)));
  }
}

std::vector<Json> features_of(const FloorPlan& plan) {
  std::vector<Json> features;
  for (const PlanRoom& room : plan.rooms) features.push_back(feature_of(room));
  for (const PlanDoor& door : plan.doors) features.push_back(feature_of(door));
  for (const Polygon& wall : plan.walls) {
    append_body(wall, {{"kind", "wall"}, {"indoor", "wall"}}, features);
  }
  for (const PlanFurniture& piece : plan.furniture) {
    append_body(piece.outline, properties_of(piece), features);
  }
  append_edges(plan.edges, features);
  return features;
}

}  // namespace

std::string to_geojson(const FloorPlan& plan) {
  // One feature a line: short for a machine, and a change of one room is a change of one line.
  std::string text = "{\"type\":\"FeatureCollection\",\n\"roomatlas\":" + compact(header_of(plan)) +
                     ",\n\"features\":[";
  const char* separator = "\n";
  for (const Json& feature : features_of(plan)) {
    text += separator + compact(feature);
    separator = ",\n";
  }
  return text + "\n]}\n";
}

}  // namespace roomatlas
