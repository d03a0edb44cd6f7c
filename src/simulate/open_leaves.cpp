// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/simulate/world.hpp"

namespace roomatlas {

Ring leaf_outline(const Segment2& leaf) {
  const Point2 along = leaf.b - leaf.a;
  const double length_m = along.norm();
  if (!(length_m > 0.0)) return {};
  const Point2 aside = kLeafThickness_m / 2.0 / length_m * Point2(-along.y(), along.x());
  return {leaf.a - aside, leaf.b - aside, leaf.b + aside, leaf.a + aside};
}

std::vector<Polygon> open_leaves(const FloorPlan& world) {
  std::vector<Polygon> leaves;
  for (const PlanDoor& door : world.doors) {
    if (!door.leaf) continue;
    Ring outline = leaf_outline(*door.leaf);
    if (!outline.empty()) leaves.push_back({std::move(outline), {}});
  }
  return leaves;
}

}  // namespace roomatlas
