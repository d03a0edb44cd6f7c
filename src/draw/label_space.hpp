// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sheet.hpp"

#include "roomatlas/plan/floor_plan.hpp"

#include <vector>

namespace roomatlas::drawing {

[[nodiscard]] bool overlap(const Box2& a, const Box2& b);

/// Whether the whole box lies in the polygon.
[[nodiscard]] bool is_inside(const Polygon& polygon_mm, const Box2& box_mm);

/// What is taken on the sheet.
class LabelSpace {
 public:
  LabelSpace(const FloorPlan& plan, const Sheet& sheet);

  /// Neither over another label nor over a door, furniture, a dimension or a note.
  [[nodiscard]] bool is_free(const Box2& box_mm) const;
  /// Over no room, wall or door.
  [[nodiscard]] bool is_outside_building(const Box2& box_mm) const;
  void occupy(const Box2& box_mm) { taken_.push_back(box_mm); }

 private:
  std::vector<Box2> taken_;
  std::vector<Polygon> building_mm_;
};

}  // namespace roomatlas::drawing
