// SPDX-License-Identifier: GPL-3.0-or-later
#include "things.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomatlas::changes {
namespace {

constexpr double kWidestDoor_m = 1.8;  // what stands in wider ones is a wall, or furniture
constexpr double kBesideJamb_m = 0.1;  // of what shuts a door, along the wall
constexpr double kMostOfIt = 0.75;     // of its cells
constexpr double kLeastFilled = 0.35;  // of a door's width: near jambs nothing can be told
constexpr double kHalf = 0.5;          // of its cells
constexpr double kThickestLeaf_m = 0.25;
constexpr double kHinge_m = 0.4;     // from a jamb to the nearer end of what is seen of a leaf
constexpr double kSlender = 3.0;     // the length of a wall that sticks out, over its thickness
constexpr double kFoot_m = 0.2;      // from a wall to where it is seen, and beyond `apart_m`
constexpr double kDeepest_m = 0.65;  // from walls to its free end: cupboards end before
constexpr double kDeep_m = 0.55;     // the same of its middle

template <typename Holds>
double share_where(const std::vector<Point2>& points, Holds holds) {
  const auto count = std::count_if(points.begin(), points.end(), holds);
  return static_cast<double>(count) / static_cast<double>(points.size());
}

/// Whether it stands between the jambs.
bool fills(const Altered& altered, const DoorPlace& door, const ChangeOptions& options) {
  if (door.width_m > kWidestDoor_m || door.width_m <= 0.0) return false;
  const Point2 along = (door.jambs.b - door.jambs.a) / door.width_m;
  double low_m = door.width_m;
  double high_m = -door.width_m;
  const double share = share_where(altered.points, [&](const Point2& point) {
    const Point2 off = point - door.middle();
    const double along_m = along.dot(off);
    const bool is_inside = std::abs(cross(along, off)) <= options.door_reach_m &&
                           std::abs(along_m) <= door.width_m / 2.0 + kBesideJamb_m;
    if (is_inside) {
      low_m = std::min(low_m, along_m);
      high_m = std::max(high_m, along_m);
    }
    return is_inside;
  });
  return share >= kMostOfIt && high_m - low_m >= kLeastFilled * door.width_m;
}

/// Whether it is the door's leaf: as a plan has it, or something as thin and as long at a jamb.
bool is_leaf(const Altered& altered, const DoorPlace& door, const ChangeOptions& options) {
  for (const Segment2& leaf : door.leaves) {
    const double share = share_where(altered.points, [&](const Point2& point) {
      return distance(leaf, point) <= options.leaf_reach_m;
    });
    if (share >= kMostOfIt) return true;
  }
  if (door.width_m > kWidestDoor_m) return false;
  const Extent extent = extent_of(altered.points);
  if (extent.width_m > kThickestLeaf_m || extent.length_m > door.width_m + options.leaf_reach_m) {
    return false;
  }
  for (const Point2& jamb : {door.jambs.a, door.jambs.b}) {
    double nearest_m = kHinge_m + 1.0;
    double farthest_m = 0.0;
    for (const Point2& point : altered.points) {
      nearest_m = std::min(nearest_m, (point - jamb).norm());
      farthest_m = std::max(farthest_m, (point - jamb).norm());
    }
    const bool looks_at_jamb = farthest_m - nearest_m >= 0.8 * extent.length_m;
    if (nearest_m <= kHinge_m && looks_at_jamb &&
        farthest_m <= door.width_m + options.leaf_reach_m) {
      return true;
    }
  }
  return false;
}

/// How far a point is from a plan's walls, in metres; 0 inside.
double from_walls_m(const FloorPlan& plan, const Point2& point) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Polygon& wall : plan.walls) {
    nearest_m = std::min(nearest_m, distance_m(wall, point));
  }
  return nearest_m;
}

/// Whether it is a wall that sticks out of another: long and thin, with one end near walls that
/// stand in both missions, and the other in the room. What stands along a wall is furniture.
bool sticks_out(const Extent& extent, const FloorPlan& other, const ChangeOptions& options) {
  if (extent.length_m < options.shortest_wall_m ||
      extent.width_m > std::min(options.longest_across_m, extent.length_m / kSlender)) {
    return false;
  }
  const Point2 half = extent.length_m / 2.0 * extent.along;
  const auto [foot_m, end_m] = std::minmax(
      {from_walls_m(other, extent.middle - half), from_walls_m(other, extent.middle + half)});
  return foot_m <= options.apart_m + kFoot_m && end_m >= kDeepest_m &&
         from_walls_m(other, extent.middle) >= std::min(kDeep_m, kHalf * extent.length_m);
}

/// The piece of furniture that most of it belongs to, and the share that does.
struct Piece {
  std::optional<std::size_t> place;
  double share = kHalf;
};
Piece piece_of(const Altered& altered, const FloorPlan& plan, double reach_m) {
  Piece best;
  for (std::size_t i = 0; i < plan.furniture.size(); ++i) {
    const double share = share_where(altered.points, [&](const Point2& point) {
      return distance_m(plan.furniture[i].outline, point) <= reach_m;
    });
    if (share < best.share) continue;
    best = {i, share};
  }
  return best;
}

}  // namespace

std::vector<DoorPlace> doors_of(const FloorPlan& before, const FloorPlan& after) {
  std::vector<DoorPlace> doors;
  const auto add_leaf = [](const PlanDoor& door, DoorPlace& place) {
    if (door.leaf) place.leaves.push_back(*door.leaf);
  };
  for (const PlanDoor& door : before.doors) {
    if (door.kind == DoorKind::window) continue;
    doors.push_back({door.jambs, (door.jambs.a - door.jambs.b).norm(), door.id, {}});
    add_leaf(door, doors.back());
  }
  for (const PlanDoor& door : after.doors) {
    if (door.kind == DoorKind::window) continue;
    const Point2 middle = (door.jambs.a + door.jambs.b) / 2.0;
    auto same = std::find_if(doors.begin(), doors.end(), [&](const DoorPlace& place) {
      return (place.middle() - middle).norm() <= kSameDoor_m;
    });
    if (same == doors.end()) {
      doors.push_back({door.jambs, (door.jambs.a - door.jambs.b).norm(), std::nullopt, {}});
      same = std::prev(doors.end());
    }
    add_leaf(door, *same);
  }
  return doors;
}

Thing thing_of(const Altered& altered, const FloorPlan& plan, const FloorPlan& other,
               const std::vector<DoorPlace>& doors, const ChangeOptions& options) {
  for (std::size_t i = 0; i < doors.size(); ++i) {
    if (fills(altered, doors[i], options)) return {ThingKind::gap, i, {}};
  }
  for (std::size_t i = 0; i < doors.size(); ++i) {
    if (is_leaf(altered, doors[i], options)) return {ThingKind::leaf, i, {}};
  }
  const Piece piece = piece_of(altered, plan, options.wall_reach_m);
  const double of_walls = share_where(altered.points, [&](const Point2& point) {
    return from_walls_m(plan, point) <= options.wall_reach_m;
  });
  const Extent extent = extent_of(altered.points);
  const bool is_drawn = of_walls > piece.share && extent.length_m >= options.shortest_wall_m &&
                        extent.width_m <= options.longest_across_m &&
                        from_walls_m(other, extent.middle) >= kDeepest_m;
  if (is_drawn || sticks_out(extent, other, options)) return {ThingKind::wall, 0, {}};
  return {ThingKind::furniture, 0, piece.place};
}

}  // namespace roomatlas::changes
