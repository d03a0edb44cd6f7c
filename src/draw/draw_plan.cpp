// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draw/dimensions.hpp"
#include "roomatlas/draw/draw.hpp"

#include "plan_layers.hpp"
#include "room_labels.hpp"
#include "sheet.hpp"
#include "style.hpp"
#include "svg.hpp"
#include "title_block.hpp"

#include <algorithm>

namespace roomatlas {
namespace {

using namespace drawing;

constexpr int kMaxSheets = 4;  // tried, while notes grow as labels lose their places

/// In axes that are turned by `turn_rad`.
Box2 building_box(const FloorPlan& plan, double turn_rad) {
  Box2 box;
  const auto extend = [&](const Ring& ring) {
    for (const Point2& point : ring) {
      if (point.allFinite()) box.extend(in_turned_axes(point, turn_rad));
    }
  };
  for (const PlanRoom& room : plan.rooms) {
    for (const Polygon& part : room.parts) extend(part.outer);
  }
  for (const Polygon& wall : plan.walls) extend(wall.outer);
  for (const PlanDoor& door : plan.doors) extend(door.opening);
  return box;
}

/// What the labels could not say, broken into lines of the sheet's width.
std::vector<std::string> notes_of(const FloorPlan& plan, const std::vector<RoomLabel>& labels,
                                  const Sheet& sheet) {
  const double width_mm = sheet.drawing_mm.size().x();
  std::vector<std::string> lines;
  for (const PlanRoom& room : plan.rooms) {
    const auto label = std::find_if(labels.begin(), labels.end(), [&](const RoomLabel& candidate) {
      return candidate.room == room.id;
    });
    if (label != labels.end() && label->shows_area) continue;
    const std::string entry = room.name + ":\u00a0" + area_text(room.area_m2) +
                              (label == labels.end() ? " (not labelled)" : "");
    const std::string longer =
        lines.empty() ? "Small rooms: " + entry : lines.back() + ", " + entry;
    if (lines.empty()) {
      lines.push_back(longer);
    } else if (text_width_mm(longer, kNoteSize_mm, Weight::normal) <= width_mm) {
      lines.back() = longer;
    } else {
      lines.push_back(entry);
    }
  }
  return lines;
}

/// A sheet, the labels on it, and the notes that it has kept a place for.
struct Layout {
  Sheet sheet;
  std::vector<RoomLabel> labels;
  std::vector<std::string> notes;
};

Layout lay_out(const FloorPlan& plan, bool has_graph) {
  const double turn_rad = main_direction_rad(plan);
  const Box2 box = building_box(plan, turn_rad);
  Layout layout;
  for (int attempt = 0; attempt < kMaxSheets; ++attempt) {
    const double notes_mm = kNoteLine_mm * static_cast<double>(layout.notes.size());
    layout.sheet = choose_sheet(box, notes_mm, turn_rad);
    const auto nodes = has_graph ? graph_nodes(plan, layout.sheet) : std::vector<Box2>{};
    layout.labels = place_labels(plan, layout.sheet, nodes);
    const std::size_t reserved = layout.notes.size();
    layout.notes = notes_of(plan, layout.labels, layout.sheet);
    if (layout.notes.size() <= reserved) break;
  }
  return layout;
}

void add_notes(pugi::xml_node svg, const Layout& layout) {
  pugi::xml_node group = add_layer(svg, "notes");
  const Box2& area = layout.sheet.drawing_mm;
  double baseline =
      area.max.y() - 1.0 - kNoteLine_mm * (static_cast<double>(layout.notes.size()) - 1.0);
  for (const std::string& note : layout.notes) {
    add_text(group, {area.min.x(), baseline}, note, {kNoteSize_mm, {}, {}, kFaintInk});
    baseline += kNoteLine_mm;
  }
}

void add_empty_notice(pugi::xml_node svg, const Sheet& sheet) {
  const Point2 centre = (sheet.drawing_mm.min + sheet.drawing_mm.max) / 2.0;
  add_text(svg, centre, "This plan is empty", {7.0, Weight::bold, Anchor::middle, kInk});
  add_text(svg, centre + Point2(0.0, 8.0), "The mission holds no room that could be drawn.",
           {3.2, Weight::normal, Anchor::middle, kFaintInk});
}

}  // namespace

std::string draw_plan(const FloorPlan& plan, const PlanAnnotations& annotations,
                      const DrawOptions& options) {
  const Layout layout = lay_out(plan, options.show_room_graph);
  const Sheet& sheet = layout.sheet;
  pugi::xml_document document;
  pugi::xml_node svg = add_page(document, sheet.size_mm.x(), sheet.size_mm.y(),
                                plan.title.empty() ? "Floor plan" : plan.title);
  add_rooms(svg, plan, annotations.doubtful_rooms, sheet);
  add_furniture(svg, plan, sheet);
  add_walls(svg, plan, sheet);
  add_edges(svg, plan, sheet);
  const bool has_edges = !plan.edges.empty();
  add_unexplored(svg, has_edges ? unexplored_lines(plan) : annotations.unexplored, has_edges,
                 sheet);
  add_doors(svg, plan, sheet);
  if (annotations.missions.empty()) {
    add_trajectory(svg, annotations.trajectory, options.show_trajectory, sheet);
  } else {
    add_mission_paths(svg, annotations.missions, options.show_trajectory, sheet);
  }
  add_room_graph(svg, plan, annotations.room_graph, options.show_room_graph, sheet);
  add_corrections(svg, annotations.corrections, options.show_corrections, sheet);
  add_uncertainty(svg, annotations.uncertainty, options.show_uncertainty, sheet);
  const bool has_lines = options.show_trajectory || options.show_room_graph ||
                         options.show_corrections || options.show_uncertainty;
  add_labels(svg, layout.labels, has_lines);
  add_door_widths(svg, plan, layout.labels, sheet);
  add_dimensions(svg, plan, sheet);
  if (plan.rooms.empty() && plan.walls.empty()) {
    add_empty_notice(svg, sheet);
  } else {
    add_notes(svg, layout);
  }
  add_title_block(svg, plan, annotations, options, sheet);
  return to_text(document);
}

}  // namespace roomatlas
