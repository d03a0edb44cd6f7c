// SPDX-License-Identifier: GPL-3.0-or-later
#include "dxf_doors.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace roomatlas::io {
namespace {

constexpr double kPanel = 0.04;  // thickness of a shut leaf, as a share of its width

/// Leaf and arc; hinged at the origin, shut it lies along x.
DoorBlock open_door(int open_deg) {
  constexpr int kSteps = 24;
  Polyline arc;
  for (int i = 0; i <= kSteps; ++i) {
    arc.emplace_back(direction(radians(open_deg * (1.0 - static_cast<double>(i) / kSteps))));
  }
  return {"DOOR-" + std::to_string(open_deg), {{{0.0, 0.0}, arc.front()}, arc}};
}

DoorBlock shut_door() {
  const double half = kPanel / 2.0;
  return {"DOOR", {{{0.0, -half}, {1.0, -half}, {1.0, half}, {0.0, half}, {0.0, -half}}}};
}

/// Faces and panes of a window whose wall is 1 deep, from -0.5 to 0.5.
DoorBlock window() {
  DoorBlock block{"WINDOW", {}};
  for (const double y : {-0.5, -0.12, 0.12, 0.5}) block.lines.push_back({{0.0, y}, {1.0, y}});
  return block;
}

double depth_of(const PlanDoor& door) {
  constexpr double kThin_m = 0.1;  // where the wall has no thickness
  const Point2 along = (door.jambs.b - door.jambs.a).normalized();
  double low_m = 0.0;
  double high_m = 0.0;
  for (const Point2& corner : door.opening) {
    const double across_m = cross(along, corner - door.jambs.a);
    low_m = std::min(low_m, across_m);
    high_m = std::max(high_m, across_m);
  }
  return high_m > low_m ? high_m - low_m : kThin_m;
}

DoorSymbol along(const Segment2& jambs, DoorBlock block) {
  const Point2 way = jambs.b - jambs.a;
  return {std::move(block), jambs.a, degrees(std::atan2(way.y(), way.x())), way.norm(), way.norm()};
}

DoorSymbol swung(const PlanDoor& door) {
  Segment2 jambs = door.jambs;  // from the hinge
  const Segment2& leaf = *door.leaf;
  if ((jambs.b - leaf.a).norm() < (jambs.a - leaf.a).norm()) std::swap(jambs.a, jambs.b);
  const Point2 shut = jambs.b - jambs.a;
  const Point2 open = leaf.b - leaf.a;
  const double turn_rad = std::atan2(cross(shut, open), shut.dot(open));
  DoorSymbol symbol =
      along(jambs, open_door(static_cast<int>(std::lround(std::abs(degrees(turn_rad))))));
  if (turn_rad < 0.0) symbol.scale_y = -symbol.scale_y;
  return symbol;
}

}  // namespace

std::optional<DoorSymbol> door_symbol(const PlanDoor& door) {
  constexpr double kLeast_m = 1e-3;
  const double width_m = (door.jambs.b - door.jambs.a).norm();
  if (!(width_m > kLeast_m)) return std::nullopt;
  if (door.kind == DoorKind::passage) {
    return along(door.jambs, {"PASSAGE", {{{0.0, 0.0}, {1.0, 0.0}}}});
  }
  if (door.kind == DoorKind::window) {
    DoorSymbol symbol = along(door.jambs, window());
    symbol.scale_y = depth_of(door);
    return symbol;
  }
  return door.leaf ? swung(door) : along(door.jambs, shut_door());
}

}  // namespace roomatlas::io
