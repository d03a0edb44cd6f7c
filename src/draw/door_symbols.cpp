// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_layers.hpp"
#include "style.hpp"
#include "svg.hpp"

#include "roomatlas/plan/door_keys.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas::drawing {
namespace {

/// A leaf on paper, and the jamb that it closes against.
struct Swing {
  Point2 hinge;
  Point2 end;     ///< the free end of the leaf
  Point2 closed;  ///< the other jamb

  [[nodiscard]] double radius() const {
    return ((end - hinge).norm() + (closed - hinge).norm()) / 2.0;
  }
};

/// The leaf turns about the jamb nearer to its hinge.
std::optional<Swing> swing_of(const PlanDoor& door, const Sheet& sheet) {
  if (!door.leaf || !door.leaf->a.allFinite() || !door.leaf->b.allFinite()) return std::nullopt;
  const Point2& hinge = door.leaf->a;
  const bool at_a = (door.jambs.a - hinge).norm() <= (door.jambs.b - hinge).norm();
  return Swing{sheet.to_paper(hinge), sheet.to_paper(door.leaf->b),
               sheet.to_paper(at_a ? door.jambs.b : door.jambs.a)};
}

/// A quarter of a circle, more or less, from the leaf to where it closes.
std::string arc_of(const Swing& swing) {
  const bool is_clockwise = cross(swing.end - swing.hinge, swing.closed - swing.hinge) > 0.0;
  const std::string radius = number(swing.radius());
  return "M" + number(swing.end.x()) + " " + number(swing.end.y()) + "A" + radius + " " + radius +
         " 0 0 " + (is_clockwise ? "1 " : "0 ") + number(swing.closed.x()) + " " +
         number(swing.closed.y());
}

/// The opening as the wall has it: two faces, and the way along them.
struct Opening {
  Segment2 near;
  Segment2 far;
};

std::optional<Opening> opening_of(const PlanDoor& door, const Sheet& sheet) {
  if (door.opening.size() != 4) return std::nullopt;
  const Ring ring = sheet.to_paper(door.opening);
  const Point2 way = sheet.to_paper.direction(door.jambs.b - door.jambs.a);
  const bool starts_across =  // the ring begins with the side of a jamb
      std::abs(cross(ring[1] - ring[0], way)) > std::abs((ring[1] - ring[0]).dot(way));
  if (starts_across) return Opening{{ring[1], ring[2]}, {ring[0], ring[3]}};
  return Opening{{ring[0], ring[1]}, {ring[3], ring[2]}};
}

void add_gap(pugi::xml_node node, const Opening& opening, const LineWeights& weights) {
  const Ring ring = {opening.near.a, opening.near.b, opening.far.b, opening.far.a};
  add(node, "path", {{"class", "gap"}, {"d", path_of({{ring, {}}})}, {"fill", kDoorFill}});
  // Over the outlines of the rooms on both sides, but not over the jambs.
  const Attributes blank = {{"stroke", kDoorFill}, {"stroke-width", number(weights.cut)}};
  for (const Segment2& face : {opening.near, opening.far}) add_line(node, face.a, face.b, blank);
}

void add_faces(pugi::xml_node node, const Opening& opening, const Attributes& attributes) {
  for (const Segment2& face : {opening.near, opening.far}) {
    add_line(node, face.a, face.b, attributes);
  }
}

/// Lines along the opening, at shares of its depth.
void add_panes(pugi::xml_node node, const Opening& opening, const LineWeights& weights) {
  for (const double share : {0.38, 0.62}) {
    add_line(node, opening.near.a + share * (opening.far.a - opening.near.a),
             opening.near.b + share * (opening.far.b - opening.near.b),
             {{"class", "pane"}, {"stroke", kWallFill}, {"stroke-width", number(weights.visible)}});
  }
}

void add_swing(pugi::xml_node node, const Swing& swing, const LineWeights& weights) {
  add_line(node, swing.hinge, swing.end,
           {{"class", "leaf"}, {"stroke", kWallFill}, {"stroke-width", number(weights.cut)}});
  add(node, "path",
      {{"class", "arc"},
       {"fill", "none"},
       {"stroke", kFaintInk},
       {"stroke-width", number(weights.fine)},
       {"d", arc_of(swing)}});
}

void add_symbol(pugi::xml_node node, const PlanDoor& door, const Sheet& sheet) {
  const LineWeights weights = line_weights(sheet.scale);
  const Attributes threshold = {
      {"class", "threshold"}, {"stroke", kFaintInk}, {"stroke-width", number(weights.fine)}};
  Attributes lintel = threshold;
  lintel[0].second = "lintel";
  lintel.emplace_back("stroke-dasharray", kLintelDash);
  const Attributes face = {
      {"class", "sill"}, {"stroke", kWallFill}, {"stroke-width", number(weights.visible)}};
  const auto opening = opening_of(door, sheet);
  if (opening) {
    add_gap(node, *opening, weights);
    const bool is_window = door.kind == DoorKind::window;
    add_faces(node, *opening,
              is_window                        ? face
              : door.kind == DoorKind::passage ? lintel
                                               : threshold);
    if (is_window) add_panes(node, *opening, weights);
  } else {  // a wall without thickness
    add_line(node, sheet.to_paper(door.jambs.a), sheet.to_paper(door.jambs.b),
             door.kind == DoorKind::passage ? lintel : threshold);
  }
  if (const auto swing = swing_of(door, sheet)) add_swing(node, *swing, weights);
}

std::string name_of(const std::optional<RoomId>& id, const FloorPlan& plan) {
  const PlanRoom* room = id ? find_room(plan, *id) : nullptr;
  return room == nullptr ? "outside" : room->name;
}

/// "between Lab and 4", "between Lab and outside".
std::string between_rooms(const PlanDoor& door, const FloorPlan& plan) {
  const bool has_first = door.room_a.has_value();
  return "between " + name_of(has_first ? door.room_a : door.room_b, plan) + " and " +
         name_of(has_first ? door.room_b : door.room_a, plan);
}

}  // namespace

void add_doors(pugi::xml_node svg, const FloorPlan& plan, const Sheet& sheet) {
  pugi::xml_node group = add_layer(svg, "doors");
  const std::vector<std::string> keys = door_keys(plan);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const PlanDoor& door = plan.doors[i];
    if (!door.jambs.a.allFinite() || !door.jambs.b.allFinite()) continue;
    pugi::xml_node node = add_group(group, ("door-" + keys[i]).c_str(),
                                    {{"class", to_string(door.kind)},
                                     {"data-door", std::to_string(door.id)},
                                     {"data-width-m", fixed(door.width_m, 3)}});
    add_title(node, std::string(to_string(door.kind)) + " " + between_rooms(door, plan) + ", " +
                        fixed(door.width_m, 2) + " m");
    add_symbol(node, door, sheet);
  }
}

Box2 door_box(const PlanDoor& door, const Sheet& sheet) {
  Box2 box;
  for (const Point2& corner : door.opening) box.extend(sheet.to_paper(corner));
  for (const Point2& jamb : {door.jambs.a, door.jambs.b}) box.extend(sheet.to_paper(jamb));
  if (const auto swing = swing_of(door, sheet)) {
    box.extend(swing->end);
    const Point2 bisector =
        ((swing->end - swing->hinge).normalized() + (swing->closed - swing->hinge).normalized());
    if (bisector.norm() > 1e-6) {
      box.extend(swing->hinge + swing->radius() * bisector.normalized());
    }
  }
  return box;
}

}  // namespace roomatlas::drawing
