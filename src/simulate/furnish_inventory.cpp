// SPDX-License-Identifier: GPL-3.0-or-later
#include "furnish_room.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr double kCorridorWidthM = 3.2;   // wider is no corridor unless it is called one
constexpr double kCorridorSquares = 4.0;  // so many squares of its width, or more
constexpr double kHallM2 = 60.0;          // from here on a room is furnished as a hall
constexpr double kStoreM2 = 6.0;          // up to here as a store

/// The diameter of the largest circle in the room.
double width_m(const PlanRoom& room) {
  if (room.parts.empty()) return 0.0;
  const Point2 middle = interior_point(room.parts.front());
  double radius_m = distance_to_boundary(room.parts.front().outer, middle);
  for (const Ring& hole : room.parts.front().holes) {
    radius_m = std::min(radius_m, distance_to_boundary(hole, middle));
  }
  return 2.0 * radius_m;
}

/// A number around a mean, in the long run the mean: from 0.6 to 1.4 of it, rounded by chance.
int some(double mean, RandomStream& random) {
  return static_cast<int>(mean * (0.6 + 0.8 * random.uniform()) + random.uniform());
}

}  // namespace

Inventory inventory_of(const PlanRoom& room, double amount, RandomStream& random) {
  double floor_m2 = 0.0;
  for (const Polygon& part : room.parts) floor_m2 += area(part);
  const double across_m = width_m(room);
  const bool is_narrow =
      across_m < kCorridorWidthM && floor_m2 > kCorridorSquares * across_m * across_m;
  Inventory inventory;
  const auto one_each = [&](double m2) { return some(amount * floor_m2 / m2, random); };
  if (room.kind == RoomKind::corridor || (room.kind == RoomKind::room && is_narrow)) {
    inventory.rows = one_each(40.0);
    inventory.boxes = one_each(60.0);
    inventory.longest_row_m = 2.0;
    inventory.deepest_row_m = 0.45;
  } else if (room.kind == RoomKind::hall || floor_m2 >= kHallM2) {
    inventory.rows = one_each(25.0);
    inventory.islands = one_each(80.0);
    inventory.desks = one_each(60.0);
    inventory.tables = one_each(25.0);
    inventory.boxes = one_each(30.0);
  } else if (floor_m2 > kStoreM2) {
    inventory.rows = one_each(12.0);
    inventory.desks = one_each(12.0);
    inventory.tables = one_each(25.0);
    inventory.boxes = one_each(20.0);
  } else {
    inventory.rows = one_each(5.0);
    inventory.boxes = one_each(5.0);
    inventory.longest_row_m = 2.0;
  }
  return inventory;
}

}  // namespace roomatlas
