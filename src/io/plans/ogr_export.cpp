// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/ogr_export.hpp"

#include "roomatlas/core/issue.hpp"

#ifdef ROOMATLAS_GDAL

#include <ogrsf_frmts.h>

#include <algorithm>

#include "ogr_geometry.hpp"
#include "ogr_memory.hpp"

namespace roomatlas {
namespace {

using namespace ogr;

/// Where layers of building metres go.
struct Target {
  GDALDataset* dataset = nullptr;
  OGRSpatialReference metres;
};

OGRLayer& new_layer(Target& target, const char* name, OGRwkbGeometryType type) {
  OGRLayer* layer = target.dataset->CreateLayer(name, &target.metres, type);
  if (layer == nullptr) throw InputError("layer " + std::string(name) + ": " + last_error());
  return *layer;
}

void add_field(OGRLayer& layer, const char* name, OGRFieldType type) {
  OGRFieldDefn field(name, type);
  if (layer.CreateField(&field) != OGRERR_NONE) throw InputError(last_error());
}

void add_rooms(Target& target, const FloorPlan& plan) {
  OGRLayer& layer = new_layer(target, "rooms", wkbMultiPolygon);
  add_field(layer, "id", OFTInteger64);
  add_field(layer, "name", OFTString);
  add_field(layer, "kind", OFTString);
  add_field(layer, "area_m2", OFTReal);
  for (const PlanRoom& room : plan.rooms) {
    OGRFeature feature(layer.GetLayerDefn());
    feature.SetField(0, static_cast<GIntBig>(room.id));
    feature.SetField(1, room.name.c_str());
    feature.SetField(2, to_string(room.kind));
    feature.SetField(3, room.area_m2);
    add(layer, feature, to_ogr(room.parts));
  }
}

void add_doors(Target& target, const FloorPlan& plan) {
  OGRLayer& layer = new_layer(target, "doors", wkbLineString);
  add_field(layer, "id", OFTInteger64);
  add_field(layer, "width_m", OFTReal);
  add_field(layer, "room_a", OFTInteger64);
  add_field(layer, "room_b", OFTInteger64);
  add_field(layer, "kind", OFTString);
  for (const PlanDoor& door : plan.doors) {
    OGRFeature feature(layer.GetLayerDefn());
    feature.SetField(0, static_cast<GIntBig>(door.id));
    feature.SetField(1, door.width_m);
    if (door.room_a) feature.SetField(2, static_cast<GIntBig>(*door.room_a));
    if (door.room_b) feature.SetField(3, static_cast<GIntBig>(*door.room_b));
    feature.SetField(4, to_string(door.kind));
    add(layer, feature, to_ogr(Polyline{door.jambs.a, door.jambs.b}));
  }
}

void add_furniture(Target& target, const FloorPlan& plan) {
  OGRLayer& layer = new_layer(target, "furniture", wkbPolygon);
  add_field(layer, "id", OFTInteger64);
  add_field(layer, "kind", OFTString);
  GIntBig id = 0;
  for (const PlanFurniture& piece : plan.furniture) {
    OGRFeature feature(layer.GetLayerDefn());
    feature.SetField(0, ++id);
    feature.SetField(1, to_string(piece.kind));
    add(layer, feature, to_ogr(piece.outline));
  }
}

void add_edges(Target& target, const FloorPlan& plan) {
  OGRLayer& layer = new_layer(target, "edges", wkbLineString);
  add_field(layer, "room", OFTInteger64);
  add_field(layer, "evidence", OFTString);
  add_field(layer, "deviation", OFTReal);  // ten letters: a shapefile has no more
  for (const PlanEdge& edge : plan.edges) {
    OGRFeature feature(layer.GetLayerDefn());
    feature.SetField(0, static_cast<GIntBig>(edge.room));
    feature.SetField(1, to_string(edge.evidence));
    if (edge.deviation_m) feature.SetField(2, *edge.deviation_m);
    add(layer, feature, to_ogr(Polyline{edge.line.a, edge.line.b}));
  }
}

/// Leaves of doors that were seen, as they stood: from hinge to free end.
void add_leaves(Target& target, const FloorPlan& plan) {
  OGRLayer& layer = new_layer(target, "leaves", wkbLineString);
  add_field(layer, "door", OFTInteger64);
  for (const PlanDoor& door : plan.doors) {
    if (!door.leaf) continue;
    OGRFeature feature(layer.GetLayerDefn());
    feature.SetField(0, static_cast<GIntBig>(door.id));
    add(layer, feature, to_ogr(Polyline{door.leaf->a, door.leaf->b}));
  }
}

bool has_leaves(const FloorPlan& plan) {
  return std::any_of(plan.doors.begin(), plan.doors.end(),
                     [](const PlanDoor& door) { return door.leaf.has_value(); });
}

void add_bodies(Target& target, const char* name, const std::vector<Polygon>& bodies) {
  OGRLayer& layer = new_layer(target, name, wkbPolygon);
  add_field(layer, "id", OFTInteger64);
  GIntBig id = 0;
  for (const Polygon& body : bodies) {
    OGRFeature feature(layer.GetLayerDefn());
    feature.SetField(0, ++id);
    add(layer, feature, to_ogr(body));
  }
}

std::string file_stem(const std::string& driver) {
  std::string stem = "plan_" + driver;
  std::replace_if(
      stem.begin(), stem.end(), [](char c) { return c == ' ' || c == '/'; }, '_');
  return stem;
}

/// A folder for formats that hold one layer a file, else a file.
std::string dataset_name(GDALDriver& driver, const std::string& name) {
  for (const char* of_folders : {"ESRI Shapefile", "FlatGeobuf", "CSV", "MapInfo File"}) {
    if (name == of_folders) return file_stem(name);
  }
  const char* extension = driver.GetMetadataItem(GDAL_DMD_EXTENSION);
  return file_stem(name) + (extension == nullptr ? "" : std::string(".") + extension);
}

}  // namespace

bool has_ogr() { return true; }

std::vector<std::string> write_ogr(const std::filesystem::path& out, const std::string& driver_name,
                                   const FloorPlan& plan) {
  GDALDriver* driver = driver_of(driver_name);
  const MemoryFolder memory("plan");
  Target target;
  target.metres.SetLocalCS("Building metres");
  target.metres.SetLinearUnits(SRS_UL_METER, 1.0);
  const std::string name = dataset_name(*driver, driver_name);
  try {
    const Dataset dataset = create(*driver, memory.path(name), {});
    target.dataset = dataset.get();
    add_rooms(target, plan);
    add_doors(target, plan);
    add_bodies(target, "walls", plan.walls);
    if (!plan.furniture.empty()) add_furniture(target, plan);
    if (!plan.edges.empty()) add_edges(target, plan);
    if (has_leaves(plan)) add_leaves(target, plan);
  } catch (const InputError& error) {
    throw InputError((out / name).string() + ": " + driver_name +
                     " cannot hold the plan: " + error.what());
  }
  return memory.write_to(out);
}

}  // namespace roomatlas

#else

namespace roomatlas {

bool has_ogr() { return false; }

void write_dxf(const std::filesystem::path&, const FloorPlan&) {
  throw UsageError("DXF needs GDAL, and this build has none: install libgdal-dev and build again");
}

std::vector<std::string> write_ogr(const std::filesystem::path&, const std::string& driver,
                                   const FloorPlan&) {
  throw UsageError(driver +
                   " needs GDAL, and this build has none: install libgdal-dev and build again");
}

}  // namespace roomatlas

#endif
