// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdio>
#include <map>

#include "plans/dxf_doors.hpp"
#include "plans/vector_files.hpp"
#include "roomatlas/draw/dimensions.hpp"
#include "roomatlas/draw/markup_text.hpp"
#include "roomatlas/io/plans/ogr_export.hpp"

namespace roomatlas {
namespace {

using namespace io;

constexpr double kName_m = 0.3;    // height of text in the building
constexpr double kWidth_m = 0.15;  // the same for widths of doors

/// Entities on layers.
class Drawing {
 public:
  /// Closed: the first point stands again at the end.
  void add_ring(const char* on, const Ring& ring) {
    Polyline line = ring;
    if (!ring.empty()) line.push_back(ring.front());
    add(on, line, "");
  }
  /// An INSERT of its block, which must be there.
  void add_symbol(const char* on, const DoorSymbol& symbol) {
    const std::string scale =
        "(3:" + std::to_string(symbol.scale_x) + "," + std::to_string(symbol.scale_y) + ",1)";
    entities_.features.push_back(
        {symbol.at, {std::string(on), symbol.block.name, symbol.turn_deg, scale}, ""});
  }
  void add_line(const char* on, const Polyline& line) { add(on, line, ""); }
  void add_polygons(const char* on, const std::vector<Polygon>& polygons) {
    for (const Polygon& polygon : polygons) {
      add_ring(on, polygon.outer);
      for (const Ring& hole : polygon.holes) add_ring(on, hole);
    }
  }
  /// Centred at the point. @param turn_deg counter-clockwise
  void add_text(const char* on, const Point2& at, const std::string& text, double height_m,
                double turn_deg = 0.0) {
    std::string escaped;  // a line end within it would begin a group of the file
    for (const char c : xml_characters(text)) {
      if (c == '"' || c == '\\') escaped += '\\';
      escaped += c;
    }
    const std::string style = "LABEL(f:\"Arial\",t:\"" + escaped +
                              "\",p:5,a:" + std::to_string(turn_deg) +
                              ",s:" + std::to_string(height_m) + "g,c:#000000)";
    add(on, at, style);
  }
  [[nodiscard]] const VectorLayer& entities() const { return entities_; }

 private:
  void add(const char* on, const VectorShape& shape, const std::string& style) {
    entities_.features.push_back({shape, {std::string(on), {}, {}, {}}, style});
  }

  VectorLayer entities_{"entities",
                        LayerShape::any,
                        {{"Layer", FieldType::text},
                         {"BlockName", FieldType::text},
                         {"BlockAngle", FieldType::real},
                         {"BlockScale", FieldType::text}},
                        {}};
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

const char* layer_of(WallEvidence evidence) {
  switch (evidence) {
    case WallEvidence::inferred:
      return "A-WALL-INFR";
    case WallEvidence::unexplored:
      return "A-WALL-UNEX";
    case WallEvidence::measured:
      break;
  }
  return "A-WALL-MEAS";
}

void draw(Drawing& drawing, const PlanDoor& door) {
  const bool is_window = door.kind == DoorKind::window;
  const char* const on = is_window ? "A-GLAZ" : "A-DOOR";
  if (!door.opening.empty()) drawing.add_ring(on, door.opening);
  if (const auto symbol = door_symbol(door)) drawing.add_symbol(on, *symbol);
  drawing.add_text(is_window ? "A-GLAZ-IDEN" : "A-DOOR-IDEN", (door.jambs.a + door.jambs.b) / 2.0,
                   two_decimals(door.width_m), kWidth_m);
}

/// A row of a chain: its line, ticks, extension lines and lengths.
void draw_row(Drawing& drawing, const DimensionChain& chain, const std::vector<double>& stations_m,
              double out_m) {
  constexpr const char* kLayer = "A-ANNO-DIMS";
  constexpr double kText_m = 0.2;        // height of text
  constexpr double kLift_m = 0.18;       // of its middle above the line
  constexpr double kTextWidth_m = 0.65;  // of "4.26"
  constexpr double kTick_m = 0.09;       // to each side
  const auto at = [&](double station_m, double further_m) {
    return Point2(chain.origin + station_m * chain.along + (out_m + further_m) * chain.outwards);
  };
  const Point2 tick = kTick_m * (chain.along - chain.outwards);
  drawing.add_line(kLayer, {at(stations_m.front(), 0.0), at(stations_m.back(), 0.0)});
  for (const double station_m : stations_m) {
    drawing.add_line(kLayer, {at(station_m, 0.0) - tick, at(station_m, 0.0) + tick});
    drawing.add_line(kLayer, {at(station_m, -0.3), at(station_m, 0.1)});
  }
  const double turn_deg = degrees(std::atan2(chain.along.y(), chain.along.x()));
  const Point2 above(-chain.along.y(), chain.along.x());  // as one reads it
  const std::vector<std::int64_t> parts = centimetres(stations_m);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool is_aside = stations_m[i + 1] - stations_m[i] < kTextWidth_m;
    const Point2 middle = at((stations_m[i] + stations_m[i + 1]) / 2.0, 0.0);
    drawing.add_text(kLayer, middle + (is_aside ? -1.3 : 1.0) * kLift_m * above,
                     two_decimals(0.01 * static_cast<double>(parts[i])), kText_m, turn_deg);
  }
}

void draw_dimensions(Drawing& drawing, const FloorPlan& plan) {
  constexpr double kInner_m = 1.2;  // from the outermost face of the rooms ...
  constexpr double kOuter_m = 2.0;  // ... and the overall dimension
  for (const DimensionChain& chain : dimension_chains(plan)) {
    if (chain.stations_m.size() > 2) draw_row(drawing, chain, chain.stations_m, kInner_m);
    draw_row(drawing, chain, {chain.stations_m.front(), chain.stations_m.back()}, kOuter_m);
  }
}

void draw(Drawing& drawing, const FloorPlan& plan) {
  drawing.add_polygons("A-WALL", plan.walls);
  for (const PlanEdge& edge : plan.edges) {
    drawing.add_line(layer_of(edge.evidence), {edge.line.a, edge.line.b});
  }
  for (const PlanFurniture& piece : plan.furniture) {
    const bool is_free = piece.kind == FurnitureKind::free_standing;
    drawing.add_polygons(is_free ? "A-FURN-FREE" : "A-FURN", {piece.outline});
  }
  for (const PlanRoom& room : plan.rooms) {
    drawing.add_polygons("A-AREA", room.parts);
    drawing.add_text("A-AREA-IDEN", room.label_point, room.name, kName_m);
    drawing.add_text("A-AREA-IDEN", room.label_point - Point2(0.0, 1.5 * kName_m),
                     one_decimal(room.area_m2) + " m2", 0.7 * kName_m);
  }
  for (const PlanDoor& door : plan.doors) draw(drawing, door);
  draw_dimensions(drawing, plan);
}

/// Each block that a door of the plan stands as, once. On layer 0 they take that of the INSERT.
VectorLayer blocks_of(const FloorPlan& plan) {
  std::map<std::string, DoorBlock> blocks;
  for (const PlanDoor& door : plan.doors) {
    if (const auto symbol = door_symbol(door)) {
      blocks.emplace(symbol->block.name, symbol->block);
    }
  }
  VectorLayer layer{
      "blocks", LayerShape::any, {{"Layer", FieldType::text}, {"Block", FieldType::text}}, {}};
  for (const auto& [name, block] : blocks) {
    for (const Polyline& line : block.lines) {
      layer.features.push_back({line, {std::string("0"), name}, ""});
    }
  }
  return layer;
}

}  // namespace

void write_dxf(const std::filesystem::path& file, const FloorPlan& plan) {
  Drawing drawing;
  draw(drawing, plan);
  write_vector_file(file.parent_path(),
                    {"DXF", file.filename().string(), {blocks_of(plan), drawing.entities()}});
}

}  // namespace roomatlas
