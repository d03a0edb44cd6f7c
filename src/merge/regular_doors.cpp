// SPDX-License-Identifier: GPL-3.0-or-later
#include "regular_doors.hpp"

#include "ring_edges.hpp"
#include "wall_lines.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace roomatlas {
namespace {

/// The rings of the rooms on both sides of a door.
std::vector<Ring*> rings_beside(const Door& door, const RingsOfRooms& rings) {
  std::vector<Ring*> beside;
  for (const auto& room : {door.room_a, door.room_b}) {
    const auto found = room ? rings.find(*room) : rings.end();
    if (found != rings.end()) {
      beside.insert(beside.end(), found->second.begin(), found->second.end());
    }
  }
  return beside;
}

/// The direction of the walls beside a door, along the door: that of most of their length.
std::optional<Point2> wall_direction_at(const Door& door, const std::vector<Ring*>& beside,
                                        const std::vector<double>& directions_rad,
                                        const RegularWallOptions& options) {
  constexpr double kReach_m = 0.5;  // of walls beside the door
  const Point2 along = (door.jambs.b - door.jambs.a).normalized();
  const Point2 middle = (door.jambs.a + door.jambs.b) / 2.0;
  const double reach_m = kReach_m + (door.jambs.b - door.jambs.a).norm() / 2.0;
  const double least_cosine = std::cos(radians(options.max_door_turn_deg));
  std::map<int, double> length_m;  // by direction, modulo half a turn
  for (const Ring* ring : beside) {
    for_each_edge(*ring, [&](const Point2& a, const Point2& b) {
      if (distance(Segment2{a, b}, middle) > reach_m) return;
      const auto edge = regular_edge(a, b, directions_rad, options);
      if (!edge || std::abs(edge->line.along.dot(along)) < least_cosine) return;
      length_m[edge->direction / 4 * 4 + edge->direction % 2] += edge->length_m();
    });
  }
  if (length_m.empty()) return std::nullopt;
  const int most = std::max_element(length_m.begin(), length_m.end(), [](auto& a, auto& b) {
                     return a.second < b.second;
                   })->first;
  const Point2 wall =
      direction(directions_rad[static_cast<std::size_t>(most / 4)] + most % 4 * kQuarter_rad);
  return wall.dot(along) < 0.0 ? Point2(-wall) : wall;
}

}  // namespace

RingsOfRooms rings_of(std::vector<PlacedOutline>& outlines) {
  RingsOfRooms rings;
  for (PlacedOutline& placed : outlines) {
    rings[placed.room].push_back(&placed.outline.outer);
    for (Ring& hole : placed.outline.holes) rings[placed.room].push_back(&hole);
  }
  return rings;
}

void turn_into_wall(Door& door, const RingsOfRooms& rings,
                    const std::vector<double>& directions_rad, const RegularWallOptions& options) {
  constexpr double kSame_m = 1e-3;  // a vertex this near to a jamb is that jamb
  const std::vector<Ring*> beside = rings_beside(door, rings);
  const auto along = wall_direction_at(door, beside, directions_rad, options);
  if (!along) return;
  const Segment2 before = door.jambs;
  const Point2 middle = (before.a + before.b) / 2.0;
  const Point2 half = *along * (before.b - before.a).norm() / 2.0;
  static_cast<Doorway&>(door) = doorway_between({middle - half, middle + half});
  for (Ring* ring : beside) {
    for (Point2& vertex : *ring) {
      if ((vertex - before.a).norm() < kSame_m) {
        vertex = door.jambs.a;
      } else if ((vertex - before.b).norm() < kSame_m) {
        vertex = door.jambs.b;
      }
    }
  }
}

}  // namespace roomatlas
