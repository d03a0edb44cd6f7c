// SPDX-License-Identifier: GPL-3.0-or-later
#include "hatch.hpp"
#include "plan_layers.hpp"
#include "style.hpp"
#include "svg.hpp"
#include "wall_pieces.hpp"

#include <map>

namespace roomatlas::drawing {
namespace {

std::string path_of_lines(const std::vector<Segment2>& lines_mm) {
  std::string path;
  for (const Segment2& line : lines_mm) path += path_of(Polyline{line.a, line.b});
  return path;
}

Segment2 on_paper(const Segment2& line, const Sheet& sheet) {
  return {sheet.to_paper(line.a), sheet.to_paper(line.b)};
}

/// Every ring as a path of its own: they may overlap, which even-odd filling would show.
void add_rings(pugi::xml_node parent, const std::vector<Ring>& rings, const Sheet& sheet) {
  for (const Ring& ring : rings)
    add(parent, "path", {{"d", path_of({{sheet.to_paper(ring), {}}})}});
}

}  // namespace

void add_furniture(pugi::xml_node svg, const FloorPlan& plan, const Sheet& sheet) {
  const LineWeights weights = line_weights(sheet.scale);
  pugi::xml_node group = add_layer(svg, "furniture", true,
                                   {{"fill", kFurnitureFill},
                                    {"fill-rule", "evenodd"},
                                    {"stroke", kFurnitureStroke},
                                    {"stroke-width", number(weights.hatch)},
                                    {"stroke-linejoin", "round"}});
  for (std::size_t i = 0; i < plan.furniture.size(); ++i) {
    const PlanFurniture& piece = plan.furniture[i];
    const bool is_free = piece.kind == FurnitureKind::free_standing;
    const Polygon outline = sheet.to_paper({piece.outline}).front();
    add_title(add(group, "path",
                  {{"id", "furniture-" + std::to_string(i + 1)},
                   {"class", is_free ? "free-standing" : "against-wall"},
                   {"d", path_of({outline})}}),
              is_free ? "furniture, free-standing" : "furniture against a wall");
    const auto lines =
        hatched(outline, is_free ? kFreeStanding_rad : kAgainstWall_rad, kHatchPitch_mm);
    if (lines.empty()) continue;
    add(group, "path",
        {{"class", "hatch"},
         {"fill", "none"},
         {"stroke", kHatchStroke},
         {"d", path_of_lines(lines)}});
  }
}

void add_walls(pugi::xml_node svg, const FloorPlan& plan, const Sheet& sheet) {
  const std::string cut_mm = number(line_weights(sheet.scale).cut);
  pugi::xml_node layer =
      add_layer(svg, "walls", true, {{"fill", kWallFill}, {"fill-rule", "evenodd"}});
  for (std::size_t i = 0; i < plan.walls.size(); ++i) {
    add_title(add(layer, "path",
                  {{"id", "wall-" + std::to_string(i + 1)},
                   {"class", "wall"},
                   {"d", path_of(sheet.to_paper({plan.walls[i]}))}}),
              "wall");
  }
  const std::vector<Ring> thin = thin_walls(wall_faces(plan.walls), kPartition_m);
  if (!thin.empty()) {
    // With an edge, so that no seam is left between two pieces.
    pugi::xml_node partitions = add(layer, "g",
                                    {{"class", "partitions"},
                                     {"fill", kPartitionFill},
                                     {"stroke", kPartitionFill},
                                     {"stroke-width", kHairline_mm}});
    add_rings(partitions, thin, sheet);
  }
  pugi::xml_node outlines = add(layer, "g",
                                {{"class", "outlines"},
                                 {"fill", "none"},
                                 {"stroke", kWallFill},
                                 {"stroke-width", cut_mm},
                                 {"stroke-linejoin", "miter"}});
  for (const Polygon& wall : plan.walls) {
    add(outlines, "path", {{"d", path_of(sheet.to_paper({wall}))}});
  }
}

void add_edges(pugi::xml_node svg, const FloorPlan& plan, const Sheet& sheet) {
  const LineWeights weights = line_weights(sheet.scale);
  pugi::xml_node layer = add_layer(svg, "edges");
  const auto walls = assumed_pieces(plan, wall_faces(plan.walls));
  add_rings(add(layer, "g", {{"class", "assumed"}, {"fill", kPaper}}), bodies_of(walls), sheet);
  // Over the outlines of walls and rooms, which would shine through the dashes.
  pugi::xml_node blanks =
      add(layer, "g",
          {{"class", "blanks"}, {"stroke", kPaper}, {"stroke-width", number(weights.cut + 0.3)}});
  pugi::xml_node halves =
      add(layer, "g",
          {{"class", "halves"}, {"stroke", kWallFill}, {"stroke-width", number(weights.fine)}});
  pugi::xml_node dashes = add(layer, "g",
                              {{"class", "dashes"},
                               {"stroke", kInferredStroke},
                               {"stroke-width", number(weights.visible)},
                               {"stroke-dasharray", kInferredDash}});
  for (const AssumedWall& wall : walls) {
    const bool is_inferred = wall.evidence == WallEvidence::inferred;
    for (const bool is_far : {false, true}) {
      const Segment2 line = on_paper(is_far ? wall.face() : wall.edge, sheet);
      if (is_far && wall.is_half) {  // where the measured half of a wall ends
        add_line(halves, line.a, line.b);
        continue;
      }
      add_line(blanks, line.a, line.b);
      if (is_inferred) add_line(dashes, line.a, line.b, {{"class", "inferred"}});
    }
  }
}

std::vector<Polyline> unexplored_lines(const FloorPlan& plan) {
  std::vector<Polyline> lines;
  RoomId room = 0;
  for (const PlanEdge& edge : plan.edges) {
    if (edge.evidence != WallEvidence::unexplored) continue;
    constexpr double kJoined_m = 0.002;
    const bool goes_on = !lines.empty() && edge.room == room &&
                         (lines.back().back() - edge.line.a).norm() < kJoined_m;
    if (!goes_on) lines.push_back({edge.line.a});
    lines.back().push_back(edge.line.b);
    room = edge.room;
  }
  return lines;
}

}  // namespace roomatlas::drawing
