// SPDX-License-Identifier: GPL-3.0-or-later
#include "obstacles.hpp"
#include "roomatlas/simulate/world.hpp"
#include "route.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <string>

namespace roomatlas {
namespace {

std::string metres(double value_m) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value_m);
  return text;
}

std::string text_of(const Point2& point) {
  return "(" + metres(point.x()) + ", " + metres(point.y()) + ")";
}

std::string text_of(const Leg& leg) {
  return "drive: leg " + std::to_string(leg.number) + " from " + text_of(leg.line.a) + " to " +
         text_of(leg.line.b);
}

bool inside_any(const std::vector<Polygon>& polygons, const Point2& point) {
  return std::any_of(polygons.begin(), polygons.end(),
                     [&](const Polygon& polygon) { return contains(polygon, point); });
}

/// Distance from the leg to the nearest obstacle; 0 where it enters one.
double clearance_of(const Leg& leg, const std::vector<Polygon>& obstacles) {
  if (inside_any(obstacles, leg.line.a)) return 0.0;
  double clearance_m = std::numeric_limits<double>::infinity();
  for (const Segment2& edge : edges_of(obstacles)) {
    clearance_m = std::min(clearance_m, distance(leg.line, edge));
  }
  return clearance_m;
}

void require_clear(const std::vector<Polygon>& obstacles, const std::string& obstacle,
                   const Leg& leg, double needed_m) {
  const double clearance_m = clearance_of(leg, obstacles);
  if (clearance_m >= needed_m) return;
  const std::string what = clearance_m > 0.0
                               ? "comes within " + metres(clearance_m) + " m of " + obstacle
                               : "passes through " + obstacle + " (clearance 0.00 m)";
  throw InputError(text_of(leg) + " " + what + "; the robot needs " + metres(needed_m) +
                   " m from its middle: move the way-points");
}

}  // namespace

std::vector<Leg> legs_of(const Drive& drive) {
  std::vector<Leg> legs;
  for (std::size_t i = 0; i < drive.size(); ++i) {
    if (!drive[i].allFinite()) {
      throw InputError("drive: way-point " + std::to_string(i + 1) + " is not finite");
    }
    if (i > 0 && drive[i] != drive[i - 1]) legs.push_back({i, {drive[i - 1], drive[i]}});
  }
  if (legs.empty()) throw InputError("drive: expected at least two different way-points");
  return legs;
}

void require_clear(const FloorPlan& world, const std::vector<Leg>& legs, double clearance_m) {
  for (const Leg& leg : legs) {
    require_clear(world.walls, "a wall", leg, clearance_m);
    require_clear(outlines_of(world.furniture), "furniture", leg, clearance_m);
    require_clear(open_leaves(world), "an open door leaf", leg, clearance_m);
  }
}

}  // namespace roomatlas
