// SPDX-License-Identifier: GPL-3.0-or-later
#include "label_space.hpp"

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

LabelSpace::LabelSpace(const FloorPlan& plan, const Sheet& sheet) {
  for (const PlanDoor& door : plan.doors) {
    if (!door.opening.empty()) taken_.push_back(bounds(sheet.to_paper(door.opening)));
  }
  for (const Polygon& piece : sheet.to_paper(outlines_of(plan.furniture))) taken_.push_back(bounds(piece.outer));
  const Box2& content = sheet.content_mm;
  taken_.push_back({{sheet.drawing_mm.min.x(), sheet.drawing_mm.min.y()},
                    {content.min.x() - 1.0, sheet.drawing_mm.max.y()}});
  taken_.push_back({{sheet.drawing_mm.min.x(), content.max.y() + 1.0}, sheet.drawing_mm.max});
  for (const PlanRoom& room : plan.rooms) {
    const auto parts_mm = sheet.to_paper(room.parts);
    building_mm_.insert(building_mm_.end(), parts_mm.begin(), parts_mm.end());
  }
  const auto walls_mm = sheet.to_paper(plan.walls);
  building_mm_.insert(building_mm_.end(), walls_mm.begin(), walls_mm.end());
}

bool LabelSpace::is_free(const Box2& box_mm) const {
  return std::none_of(taken_.begin(), taken_.end(),
                      [&](const Box2& taken) { return overlap(taken, box_mm); });
}

bool LabelSpace::is_outside_building(const Box2& box_mm) const {
  const Point2 centre = (box_mm.min + box_mm.max) / 2.0;
  return std::none_of(building_mm_.begin(), building_mm_.end(), [&](const Polygon& body) {
    return contains(body, centre) || boundary_touches(body, box_mm);
  });
}

}  // namespace roomatlas::drawing
