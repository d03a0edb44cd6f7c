// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draw/changes.hpp"

#include <algorithm>

#include "hatch.hpp"
#include "plan_layers.hpp"
#include "roomatlas/draw/dimensions.hpp"
#include "sheet.hpp"
#include "style.hpp"
#include "svg.hpp"
#include "title_block.hpp"

namespace roomatlas {
namespace {

using namespace drawing;

// Red and green differ in lightness and in their dashes too.
constexpr const char* kGoneStroke = "#c1121f";
constexpr const char* kGoneFill = "#f6c9cc";
constexpr const char* kGoneDash = "1.2 0.7";
constexpr const char* kNewStroke = "#0b6b2e";
constexpr const char* kNewFill = "#3fae5f";
constexpr const char* kSameWall = "#9aa3ad";
constexpr const char* kSameFloor = "#ffffff";
constexpr const char* kUnseenWall = "#cfd4da";
constexpr const char* kUnseenFloor = "#f3f4f6";
constexpr const char* kUnseenHatch = "#c5cad1";
constexpr double kUnseenPitch_mm = 2.2;
constexpr double kNumber_mm = 2.4;  // of its letters
constexpr double kNumberRadius_mm = 2.1;

std::string path_of_lines(const std::vector<Segment2>& lines_mm) {
  std::string path;
  for (const Segment2& line : lines_mm) path += path_of(Polyline{line.a, line.b});
  return path;
}

void add_polygons(pugi::xml_node group, const std::vector<Polygon>& polygons, const Sheet& sheet) {
  for (const Polygon& polygon : polygons) {
    add(group, "path", {{"d", path_of(sheet.to_paper({polygon}))}});
  }
}

/// One plan in grey: floor, furniture as outlines, walls.
void add_state(pugi::xml_node svg, const char* id, const FloorPlan& plan, const char* floor,
               const char* wall, const Sheet& sheet) {
  const LineWeights weights = line_weights(sheet.scale);
  pugi::xml_node layer = add_layer(svg, id, true, {{"fill-rule", "evenodd"}});
  pugi::xml_node floors = add(layer, "g", {{"class", "floor"}, {"fill", floor}});
  for (const PlanRoom& room : plan.rooms) add_polygons(floors, room.parts, sheet);
  for (const PlanDoor& door : plan.doors) add_polygons(floors, {{door.opening, {}}}, sheet);
  add_polygons(add(layer, "g",
                   {{"class", "furniture"},
                    {"fill", "none"},
                    {"stroke", wall},
                    {"stroke-width", number(weights.fine)}}),
               outlines_of(plan.furniture), sheet);
  add_polygons(add(layer, "g", {{"class", "walls"}, {"fill", wall}}), plan.walls, sheet);
  pugi::xml_node leaves =
      add(layer, "g",
          {{"class", "leaves"}, {"stroke", wall}, {"stroke-width", number(weights.visible)}});
  for (const PlanDoor& door : plan.doors) {
    if (door.leaf) add_line(leaves, sheet.to_paper(door.leaf->a), sheet.to_paper(door.leaf->b));
  }
}

void add_unseen(pugi::xml_node svg, const std::vector<Polygon>& pieces, const Sheet& sheet) {
  pugi::xml_node layer =
      add_layer(svg, "not-seen-again", true,
                {{"fill", "none"}, {"stroke", kUnseenHatch}, {"stroke-width", kHairline_mm}});
  for (const Polygon& piece : sheet.to_paper(pieces)) {
    const auto lines = hatched(piece, kAgainstWall_rad, kUnseenPitch_mm);
    if (!lines.empty()) add(layer, "path", {{"d", path_of_lines(lines)}});
  }
}

void add_gone_and_new(pugi::xml_node svg, const PlanChanges& changes, const Sheet& sheet) {
  const std::string width = number(line_weights(sheet.scale).cut);
  pugi::xml_node gone = add_layer(svg, "gone", true,
                                  {{"fill", kGoneFill},
                                   {"fill-opacity", "0.7"},
                                   {"stroke", kGoneStroke},
                                   {"stroke-width", width},
                                   {"stroke-dasharray", kGoneDash}});
  pugi::xml_node appeared = add_layer(svg, "new", true,
                                      {{"fill", kNewFill},
                                       {"fill-opacity", "0.85"},
                                       {"stroke", kNewStroke},
                                       {"stroke-width", width}});
  for (const Change& change : changes.changes) {
    add_polygons(gone, change.gone, sheet);
    add_polygons(appeared, change.appeared, sheet);
  }
}

/// A number beside each change, where it covers no other one.
void add_numbers(pugi::xml_node svg, const PlanChanges& changes, const Sheet& sheet) {
  pugi::xml_node layer = add_layer(svg, "numbers");
  std::vector<Point2> taken;
  for (const Change& change : changes.changes) {
    const Point2 middle = sheet.to_paper(change.at);
    Point2 at = middle + Point2(3.2, -3.2);
    for (const Point2& off : {Point2(3.2, -3.2), Point2(-3.2, -3.2), Point2(3.2, 3.2),
                              Point2(-3.2, 3.2), Point2(0.0, -6.4), Point2(0.0, 6.4)}) {
      at = middle + off;
      if (std::none_of(taken.begin(), taken.end(), [&](const Point2& other) {
            return (other - at).norm() < 2.0 * kNumberRadius_mm;
          })) {
        break;
      }
    }
    taken.push_back(at);
    const std::string text = std::to_string(change.id);
    add_line(layer, middle, at, {{"stroke", kInk}, {"stroke-width", kHairline_mm}});
    add(layer, "circle",
        {{"cx", number(at.x())},
         {"cy", number(at.y())},
         {"r", number(kNumberRadius_mm)},
         {"fill", kPaper},
         {"stroke", kInk},
         {"stroke-width", kThin_mm}});
    const double size_mm = text.size() > 2 ? 0.75 * kNumber_mm : kNumber_mm;
    add_text(layer, at + Point2(0.0, size_mm * kCapHeight / 2.0), text,
             {size_mm, Weight::bold, Anchor::middle, kInk});
  }
}

std::string text_of(const Change& change) {
  std::string text = std::to_string(change.id) + "\u00a0" + to_string(change.kind);
  if (!change.room_name.empty()) text += " (" + change.room_name + ")";
  return text;
}

/// The changes and the rooms in words, in lines of the sheet's width.
std::vector<std::string> notes_of(const PlanChanges& changes, double width_mm) {
  std::vector<std::string> entries;
  for (const Change& change : changes.changes) entries.push_back(text_of(change));
  for (const OneSidedRoom& room : changes.rooms) {
    entries.push_back((room.was_before ? "not visited again: " : "first visited: ") + room.name);
  }
  if (entries.empty()) entries.emplace_back("Nothing changed in what both missions saw.");
  std::vector<std::string> lines;
  for (const std::string& entry : entries) {
    const std::string longer = lines.empty() ? entry : lines.back() + ";  " + entry;
    if (!lines.empty() && text_width_mm(longer, kNoteSize_mm, Weight::normal) <= width_mm) {
      lines.back() = longer;
    } else {
      lines.push_back(entry);
    }
  }
  return lines;
}

Box2 box_of(const FloorPlan& before, const FloorPlan& after, double turn_rad) {
  Box2 box;
  for (const FloorPlan* plan : {&before, &after}) {
    for (const PlanRoom& room : plan->rooms) {
      for (const Polygon& part : room.parts) {
        for (const Point2& point : part.outer) box.extend(in_turned_axes(point, turn_rad));
      }
    }
    for (const Polygon& wall : plan->walls) {
      for (const Point2& point : wall.outer) box.extend(in_turned_axes(point, turn_rad));
    }
  }
  return box;
}

/// A rectangle as it is drawn on the sheet.
LegendEntry sample(const char* name, const char* fill, const char* stroke, const char* dash) {
  return {name, [=](pugi::xml_node parent, const Box2& box) {
            Attributes attributes = {{"fill", fill}, {"stroke", stroke}, {"stroke-width", "0.3"}};
            if (dash != nullptr) attributes.emplace_back("stroke-dasharray", dash);
            add_rectangle(parent, box, attributes);
          }};
}

std::vector<LegendEntry> legend() {
  LegendEntry unseen = sample("not seen again", kUnseenFloor, kUnseenHatch, nullptr);
  unseen.draw = [draw = unseen.draw](pugi::xml_node parent, const Box2& box) {
    draw(parent, box);
    const Ring ring = {box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}};
    add(parent, "path",
        {{"stroke", kUnseenHatch},
         {"stroke-width", kHairline_mm},
         {"d", path_of_lines(hatched({ring, {}}, kAgainstWall_rad, 1.1))}});
  };
  return {sample("gone", kGoneFill, kGoneStroke, kGoneDash),
          sample("new", kNewFill, kNewStroke, nullptr),
          sample("unchanged", kSameWall, kSameWall, nullptr), unseen};
}

std::string said(const char* word, const std::string& mission, const std::string& date) {
  return std::string(word) + mission + (date.empty() ? "" : ", " + date);
}

std::vector<Fact> facts_of(const PlanChanges& changes) {
  const auto count = [&](ChangeKind first, ChangeKind last) {
    return std::to_string(std::count_if(
        changes.changes.begin(), changes.changes.end(),
        [&](const Change& change) { return change.kind >= first && change.kind <= last; }));
  };
  const auto not_again = std::count_if(changes.rooms.begin(), changes.rooms.end(),
                                       [](const OneSidedRoom& room) { return room.was_before; });
  return {{"Doors changed", count(ChangeKind::door_shut, ChangeKind::door_turned)},
          {"Walls changed", count(ChangeKind::wall_gone, ChangeKind::wall_moved)},
          {"Furniture changed", count(ChangeKind::furniture_gone, ChangeKind::furniture_moved)},
          {"Rooms not visited again", std::to_string(not_again)},
          {"Floor seen by both", fixed(changes.compared_m2, 0) + "\u00a0m\u00b2"}};
}

void add_notes(pugi::xml_node svg, const std::vector<std::string>& notes, const Sheet& sheet) {
  pugi::xml_node group = add_layer(svg, "notes");
  double baseline =
      sheet.drawing_mm.max.y() - 1.0 - kNoteLine_mm * (static_cast<double>(notes.size()) - 1.0);
  for (const std::string& note : notes) {
    add_text(group, {sheet.drawing_mm.min.x(), baseline}, note, {kNoteSize_mm, {}, {}, kInk});
    baseline += kNoteLine_mm;
  }
}

}  // namespace

std::string draw_changes(const FloorPlan& before, const FloorPlan& after,
                         const PlanChanges& changes, const ComparedMissions& missions,
                         const DrawOptions& options) {
  const double turn_rad = main_direction_rad(before);
  const Box2 box = box_of(before, after, turn_rad);
  Sheet sheet = choose_sheet(box, 0.0, turn_rad);
  std::vector<std::string> notes;
  for (int attempt = 0; attempt < 2; ++attempt) {  // larger paper has wider lines
    notes = notes_of(changes, sheet.drawing_mm.size().x());
    sheet = choose_sheet(box, kNoteLine_mm * static_cast<double>(notes.size()), turn_rad);
  }
  pugi::xml_document document;
  pugi::xml_node svg = add_page(document, sheet.size_mm.x(), sheet.size_mm.y(), "Changes");
  add_state(svg, "before", before, kUnseenFloor, kUnseenWall, sheet);
  add_state(svg, "after", after, kSameFloor, kSameWall, sheet);
  add_unseen(svg, changes.not_seen_again, sheet);
  add_labels(svg, place_labels(before, sheet, {}), true);
  add_gone_and_new(svg, changes, sheet);
  add_numbers(svg, changes, sheet);
  add_notes(svg, notes, sheet);
  add_title_strip(svg,
                  {"Changes",
                   {said("From ", missions.before, missions.before_date),
                    said("to ", missions.after, missions.after_date)},
                   facts_of(changes),
                   legend(),
                   options.north_deg},
                  sheet);
  return to_text(document);
}

}  // namespace roomatlas
