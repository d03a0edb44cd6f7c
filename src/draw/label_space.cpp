// SPDX-License-Identifier: GPL-3.0-or-later
#include "label_space.hpp"

#include "plan_layers.hpp"

#include <algorithm>
#include <array>

namespace roomatlas::drawing {
namespace {

/// Whether any part of the segment lies in the box (clipping after Liang and Barsky).
bool touches(const Box2& box, const Point2& a, const Point2& b) {
  double enter = 0.0;
  double leave = 1.0;
  const Point2 along = b - a;
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const double low = box.min[axis] - a[axis];
    const double high = box.max[axis] - a[axis];
    if (along[axis] == 0.0) {
      if (low > 0.0 || high < 0.0) return false;
      continue;
    }
    const auto [first, last] = std::minmax({low / along[axis], high / along[axis]});
    enter = std::max(enter, first);
    leave = std::min(leave, last);
  }
  return enter <= leave;
}

bool boundary_touches(const Ring& ring, const Box2& box) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (touches(box, ring[i], ring[(i + 1) % ring.size()])) return true;
  }
  return false;
}

bool boundary_touches(const Polygon& polygon, const Box2& box) {
  return boundary_touches(polygon.outer, box) ||
         std::any_of(polygon.holes.begin(), polygon.holes.end(),
                     [&](const Ring& hole) { return boundary_touches(hole, box); });
}

}  // namespace

bool overlap(const Box2& a, const Box2& b) {
  return (a.min.array() < b.max.array()).all() && (b.min.array() < a.max.array()).all();
}

bool is_inside(const Polygon& polygon_mm, const Box2& box_mm) {
  return !boundary_touches(polygon_mm, box_mm) &&
         contains(polygon_mm, Point2((box_mm.min + box_mm.max) / 2.0));
}

bool LabelSpace::meets(const Body& body, const Box2& box_mm) {
  return overlap(body.box, box_mm) &&
         (boundary_touches(body.shape, box_mm) ||
          contains(body.shape, Point2((box_mm.min + box_mm.max) / 2.0)));
}

LabelSpace::LabelSpace(const FloorPlan& plan, const Sheet& sheet) {
  for (const PlanDoor& door : plan.doors) {
    const Box2 box = door_box(door, sheet);
    if (!box.empty()) taken_.push_back(box);
  }
  const auto add = [](const std::vector<Polygon>& shapes, std::vector<Body>& bodies) {
    for (const Polygon& shape : shapes) bodies.push_back({shape, bounds(shape.outer)});
  };
  add(sheet.to_paper(outlines_of(plan.furniture)), furniture_mm_);
  const Box2& content = sheet.content_mm;
  taken_.push_back({{sheet.drawing_mm.min.x(), sheet.drawing_mm.min.y()},
                    {content.min.x() - 1.0, sheet.drawing_mm.max.y()}});
  taken_.push_back({{sheet.drawing_mm.min.x(), content.max.y() + 1.0}, sheet.drawing_mm.max});
  for (const PlanRoom& room : plan.rooms) add(sheet.to_paper(room.parts), building_mm_);
  add(sheet.to_paper(plan.walls), building_mm_);
}

LabelSpace LabelSpace::within(const Box2& part_mm, bool with_furniture) const {
  LabelSpace part;
  for (const Box2& taken : taken_) {
    if (overlap(taken, part_mm)) part.taken_.push_back(taken);
  }
  for (const Body& body : furniture_mm_) {
    if (with_furniture && overlap(body.box, part_mm)) part.furniture_mm_.push_back(body);
  }
  return part;
}

bool LabelSpace::has_furniture(const Box2& part_mm) const {
  return std::any_of(furniture_mm_.begin(), furniture_mm_.end(),
                     [&](const Body& body) { return overlap(body.box, part_mm); });
}

bool LabelSpace::is_free(const Box2& box_mm) const {
  return std::none_of(taken_.begin(), taken_.end(),
                      [&](const Box2& taken) { return overlap(taken, box_mm); }) &&
         std::none_of(furniture_mm_.begin(), furniture_mm_.end(),
                      [&](const Body& body) { return meets(body, box_mm); });
}

bool LabelSpace::is_outside_building(const Box2& box_mm) const {
  return std::none_of(building_mm_.begin(), building_mm_.end(),
                      [&](const Body& body) { return meets(body, box_mm); });
}

}  // namespace roomatlas::drawing
