// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/ogr_export.hpp"

#include <algorithm>

#include "plans/vector_files.hpp"

namespace roomatlas {
namespace {

using namespace io;

FieldValue integer(std::int64_t value) { return value; }
FieldValue text(const std::string& value) { return value; }

template <typename Number>
FieldValue if_known(const std::optional<Number>& value) {
  if (!value) return {};
  return *value;
}

VectorLayer rooms_of(const FloorPlan& plan) {
  VectorLayer layer{"rooms",
                    LayerShape::multi_polygons,
                    {{"id", FieldType::integer},
                     {"name", FieldType::text},
                     {"kind", FieldType::text},
                     {"area_m2", FieldType::real}},
                    {}};
  for (const PlanRoom& room : plan.rooms) {
    layer.features.push_back(
        {room.parts,
         {integer(room.id), text(room.name), text(to_string(room.kind)), room.area_m2},
         ""});
  }
  return layer;
}

VectorLayer doors_of(const FloorPlan& plan) {
  VectorLayer layer{"doors",
                    LayerShape::lines,
                    {{"id", FieldType::integer},
                     {"width_m", FieldType::real},
                     {"room_a", FieldType::integer},
                     {"room_b", FieldType::integer},
                     {"kind", FieldType::text}},
                    {}};
  for (const PlanDoor& door : plan.doors) {
    layer.features.push_back({Polyline{door.jambs.a, door.jambs.b},
                              {integer(door.id), door.width_m, if_known(door.room_a),
                               if_known(door.room_b), text(to_string(door.kind))},
                              ""});
  }
  return layer;
}

VectorLayer walls_of(const FloorPlan& plan) {
  VectorLayer layer{"walls", LayerShape::polygons, {{"id", FieldType::integer}}, {}};
  std::int64_t id = 0;
  for (const Polygon& body : plan.walls) layer.features.push_back({body, {++id}, ""});
  return layer;
}

VectorLayer furniture_of(const FloorPlan& plan) {
  VectorLayer layer{"furniture",
                    LayerShape::polygons,
                    {{"id", FieldType::integer}, {"kind", FieldType::text}},
                    {}};
  std::int64_t id = 0;
  for (const PlanFurniture& piece : plan.furniture) {
    layer.features.push_back({piece.outline, {++id, text(to_string(piece.kind))}, ""});
  }
  return layer;
}

VectorLayer edges_of(const FloorPlan& plan) {
  VectorLayer layer{"edges",
                    LayerShape::lines,
                    {{"room", FieldType::integer},
                     {"evidence", FieldType::text},
                     {"deviation", FieldType::real}},  // ten letters: a shapefile has no more
                    {}};
  for (const PlanEdge& edge : plan.edges) {
    layer.features.push_back(
        {Polyline{edge.line.a, edge.line.b},
         {integer(edge.room), text(to_string(edge.evidence)), if_known(edge.deviation_m)},
         ""});
  }
  return layer;
}

/// Leaves of doors that were seen, as they stood: from hinge to free end.
VectorLayer leaves_of(const FloorPlan& plan) {
  VectorLayer layer{"leaves", LayerShape::lines, {{"door", FieldType::integer}}, {}};
  for (const PlanDoor& door : plan.doors) {
    if (!door.leaf) continue;
    layer.features.push_back({Polyline{door.leaf->a, door.leaf->b}, {integer(door.id)}, ""});
  }
  return layer;
}

std::string file_stem(const std::string& driver) {
  std::string stem = "plan_" + driver;
  std::replace_if(
      stem.begin(), stem.end(), [](char c) { return c == ' ' || c == '/'; }, '_');
  return stem;
}

}  // namespace

std::vector<std::string> write_ogr(const std::filesystem::path& out, const std::string& driver,
                                   const FloorPlan& plan) {
  VectorFile file{driver, file_stem(driver), {rooms_of(plan), doors_of(plan), walls_of(plan)}};
  for (VectorLayer layer : {furniture_of(plan), edges_of(plan), leaves_of(plan)}) {
    if (!layer.features.empty()) file.layers.push_back(std::move(layer));
  }
  return write_vector_file(out, file);
}

}  // namespace roomatlas
