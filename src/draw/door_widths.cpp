// SPDX-License-Identifier: GPL-3.0-or-later
#include "label_space.hpp"
#include "plan_layers.hpp"
#include "style.hpp"
#include "svg.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace roomatlas::drawing {
namespace {

// Of the text, and around it.
constexpr double kSize_mm = 1.6;
constexpr double kAir_mm = 0.3;

struct WidthLabel {
  std::string text;
  Point2 centre_mm;
  Point2 size_mm;
  bool is_turned = false;

  [[nodiscard]] Box2 box_mm() const {
    const Point2 half = (is_turned ? Point2(size_mm.y(), size_mm.x()) : size_mm) / 2.0;
    return {centre_mm - half, centre_mm + half};
  }
};

/// How far the opening reaches from the door's middle, along `direction`.
double reach_mm(const Ring& opening_mm, const Point2& middle, const Point2& direction) {
  double reach = 0.0;
  for (const Point2& corner : opening_mm) {
    reach = std::max(reach, std::abs((corner - middle).dot(direction)));
  }
  return reach;
}

/// The rooms on the door's two sides, on paper.
std::vector<Polygon> sides_mm(const PlanDoor& door, const std::map<RoomId, const PlanRoom*>& rooms,
                              const Sheet& sheet) {
  std::vector<Polygon> sides;
  for (const std::optional<RoomId>& id : {door.room_a, door.room_b}) {
    const auto room = id ? rooms.find(*id) : rooms.end();
    if (room == rooms.end()) continue;
    const std::vector<Polygon> parts = sheet.to_paper(room->second->parts);
    sides.insert(sides.end(), parts.begin(), parts.end());
  }
  return sides;
}

/// On one side of the door or on the other: the first place that is free.
std::optional<WidthLabel> placed(const PlanDoor& door, const std::vector<Polygon>& rooms_mm,
                                 const LabelSpace& space, const Sheet& sheet) {
  const Segment2 jambs{sheet.to_paper(door.jambs.a), sheet.to_paper(door.jambs.b)};
  const Point2 along = (jambs.b - jambs.a).normalized();
  const Point2 across(-along.y(), along.x());
  if (!along.allFinite()) return std::nullopt;
  WidthLabel label;
  label.text = fixed(door.width_m, 2);
  label.is_turned = std::abs(along.y()) > std::abs(along.x());
  label.size_mm =
      Point2(text_width_mm(label.text, kSize_mm, Weight::normal), kSize_mm * kCapHeight) +
      Point2::Constant(2.0 * kAir_mm);
  const Point2 middle = (jambs.a + jambs.b) / 2.0;
  const Point2 half = label.box_mm().size() / 2.0;
  const double half_mm = half.x() * std::abs(across.x()) + half.y() * std::abs(across.y());
  const double distance_mm = reach_mm(sheet.to_paper(door.opening), middle, across) + half_mm + 0.3;
  for (const double side : {1.0, -1.0}) {
    label.centre_mm = middle + side * distance_mm * across;
    const Box2 box = label.box_mm();
    const bool is_in_room = std::any_of(rooms_mm.begin(), rooms_mm.end(),
                                        [&](const Polygon& room) { return is_inside(room, box); });
    if (is_in_room && space.is_free(box)) return label;
  }
  return std::nullopt;
}

}  // namespace

void add_door_widths(pugi::xml_node svg, const FloorPlan& plan,
                     const std::vector<RoomLabel>& labels, const Sheet& sheet) {
  pugi::xml_node layer = add_layer(svg, "door-widths");
  LabelSpace space(plan, sheet);
  for (const RoomLabel& label : labels) space.occupy(label.box_mm());
  std::map<RoomId, const PlanRoom*> rooms;
  for (const PlanRoom& room : plan.rooms) rooms[room.id] = &room;
  for (const PlanDoor& door : plan.doors) {
    const auto label = placed(door, sides_mm(door, rooms, sheet), space, sheet);
    if (!label) continue;
    space.occupy(label->box_mm());
    const Point2& centre = label->centre_mm;
    pugi::xml_node text =
        add_text(layer, centre + Point2(0.0, kSize_mm * kCapHeight / 2.0), label->text,
                 {kSize_mm, Weight::normal, Anchor::middle, kFaintInk});
    text.append_attribute("data-door") = std::to_string(door.id).c_str();
    if (!label->is_turned) continue;
    const std::string turn = "rotate(-90 " + number(centre.x()) + " " + number(centre.y()) + ")";
    text.append_attribute("transform") = turn.c_str();
  }
}

}  // namespace roomatlas::drawing
