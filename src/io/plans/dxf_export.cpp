// SPDX-License-Identifier: GPL-3.0-or-later
#ifdef ROOMATLAS_GDAL

#include <cpl_conv.h>

#include <cstdio>
#include <fstream>
#include <iterator>

#include "ogr_geometry.hpp"
#include "ogr_memory.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/plans/ogr_export.hpp"

namespace roomatlas {
namespace {

using namespace ogr;

constexpr double kName_m = 0.3;    // height of text in the building
constexpr double kWidth_m = 0.15;  // the same for widths of doors

/// GDAL's template of a DXF header says inches: ours are metres.
std::string header_in_metres() {
  const char* const file = CPLFindFile("gdal", "header.dxf");
  std::ifstream stream(file == nullptr ? "" : file, std::ios::binary);
  std::string header{std::istreambuf_iterator<char>(stream), {}};
  const auto set = [&](const std::string& variable, const std::string& value) {
    const std::size_t name = header.find(variable);
    const std::size_t code = name == std::string::npos ? name : header.find('\n', name);
    const std::size_t old = code == std::string::npos ? code : header.find('\n', code + 1);
    if (old == std::string::npos) throw InputError("GDAL's header.dxf lacks " + variable);
    header.replace(old + 1, header.find('\n', old + 1) - old - 1, value);
  };
  set("$INSUNITS", "6");
  set("$MEASUREMENT", "1");
  return header;
}

/// Entities on layers.
class Drawing {
 public:
  explicit Drawing(OGRLayer& layer) : layer_(layer) {}

  void add_ring(const char* on, const Ring& ring) { add(on, closed_line(ring), ""); }
  void add_polygons(const char* on, const std::vector<Polygon>& polygons) {
    for (const Polygon& polygon : polygons) {
      add_ring(on, polygon.outer);
      for (const Ring& hole : polygon.holes) add_ring(on, hole);
    }
  }
  /// Centred at the point.
  void add_text(const char* on, const Point2& at, const std::string& text, double height_m) {
    std::string escaped;
    for (const char c : text) {
      if (c == '"' || c == '\\') escaped += '\\';
      escaped += c;
    }
    const std::string style = "LABEL(f:\"Arial\",t:\"" + escaped +
                              "\",p:5,s:" + std::to_string(height_m) + "g,c:#000000)";
    add(on, OGRPoint(at.x(), at.y()), style);
  }

 private:
  void add(const char* on, const OGRGeometry& shape, const std::string& style) {
    OGRFeature feature(layer_.GetLayerDefn());
    feature.SetField("Layer", on);
    if (!style.empty()) feature.SetStyleString(style.c_str());
    ogr::add(layer_, feature, shape);
  }

  OGRLayer& layer_;
};

std::string two_decimals(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

std::string one_decimal(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

void draw(Drawing& drawing, const FloorPlan& plan) {
  drawing.add_polygons("A-WALL", plan.walls);
  drawing.add_polygons("A-FURN", outlines_of(plan.furniture));
  for (const PlanRoom& room : plan.rooms) {
    drawing.add_polygons("A-AREA", room.parts);
    drawing.add_text("A-AREA-IDEN", room.label_point, room.name, kName_m);
    drawing.add_text("A-AREA-IDEN", room.label_point - Point2(0.0, 1.5 * kName_m),
                     one_decimal(room.area_m2) + " m2", 0.7 * kName_m);
  }
  for (const PlanDoor& door : plan.doors) {
    if (!door.opening.empty()) drawing.add_ring("A-DOOR", door.opening);
    drawing.add_text("A-DOOR-IDEN", (door.jambs.a + door.jambs.b) / 2.0, two_decimals(door.width_m),
                     kWidth_m);
  }
}

}  // namespace

void write_dxf(const std::filesystem::path& file, const FloorPlan& plan) {
  GDALDriver* driver = driver_of("DXF");
  const MemoryFolder results("dxf");
  const MemoryFolder templates("header");
  templates.put("header.dxf", header_in_metres());
  {
    const Dataset dataset = create(*driver, results.path(file.filename().string()),
                                   {"HEADER=" + templates.path("header.dxf")});
    OGRLayer* layer = dataset->CreateLayer("entities");
    if (layer == nullptr) throw InputError(file.string() + ": " + last_error());
    Drawing drawing(*layer);
    draw(drawing, plan);
  }
  results.write_to(file.parent_path());
}

}  // namespace roomatlas

#endif
