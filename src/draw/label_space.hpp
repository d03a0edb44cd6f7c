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

  /// What of it matters in a part of the sheet.
  [[nodiscard]] LabelSpace within(const Box2& part_mm, bool with_furniture) const;
  [[nodiscard]] bool has_furniture(const Box2& part_mm) const;

  /// Neither over another label nor over a door, its arc, furniture, a dimension or a note.
  [[nodiscard]] bool is_free(const Box2& box_mm) const;
  /// Over no room, wall or door.
  [[nodiscard]] bool is_outside_building(const Box2& box_mm) const;
  void occupy(const Box2& box_mm) { taken_.push_back(box_mm); }

 private:
  LabelSpace() = default;

  /// A shape and its box, which tells most that is elsewhere.
  struct Body {
    Polygon shape;
    Box2 box;
  };
  [[nodiscard]] static bool meets(const Body& body, const Box2& box_mm);

  std::vector<Box2> taken_;
  std::vector<Body> furniture_mm_;
  std::vector<Body> building_mm_;
};

}  // namespace roomatlas::drawing
