// SPDX-License-Identifier: GPL-3.0-or-later
#include "things.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas::changes {
namespace {

constexpr double kSameDoor_m = 0.5;     // between the middles of a door in two plans
constexpr double kWidestDoor_m = 1.8;   // what stands in wider ones is a wall, or furniture
constexpr double kBesideJamb_m = 0.1;   // of what shuts a door, along the wall
constexpr double kMostOfIt = 0.75;      // of its cells
constexpr double kLeastFilled = 0.35;   // of a door's width: near jambs nothing can be told
constexpr double kThickestLeaf_m = 0.25;
constexpr double kHinge_m = 0.4;        // from a jamb to the nearer end of what is seen of a leaf

template <typename Holds>
double share_of(const std::vector<Point2>& points, Holds holds) {
  const auto count = std::count_if(points.begin(), points.end(), holds);
  return static_cast<double>(count) / static_cast<double>(points.size());
}

/// Whether it stands between the jambs.
bool fills(const Altered& altered, const DoorPlace& door, const ChangeOptions& options) {
  if (door.width_m > kWidestDoor_m || door.width_m <= 0.0) return false;
  const Point2 along = (door.jambs.b - door.jambs.a) / door.width_m;
  double low_m = door.width_m;
  double high_m = -door.width_m;
  const double share = share_of(altered.points, [&](const Point2& point) {
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
    const double share = share_of(altered.points, [&](const Point2& point) {
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

Thing thing_of(const Altered& altered, const FloorPlan& plan, const std::vector<DoorPlace>& doors,
               const ChangeOptions& options) {
  for (std::size_t i = 0; i < doors.size(); ++i) {
    if (fills(altered, doors[i], options)) return {ThingKind::gap, i, {}};
  }
  for (std::size_t i = 0; i < doors.size(); ++i) {
    if (is_leaf(altered, doors[i], options)) return {ThingKind::leaf, i, {}};
  }
  Thing thing;
  double most = 0.5;
  for (std::size_t i = 0; i < plan.furniture.size(); ++i) {
    const double share = share_of(altered.points, [&](const Point2& point) {
      return distance_m(plan.furniture[i].outline, point) <= options.wall_reach_m;
    });
    if (share < most) continue;
    most = share;
    thing.piece = i;
  }
  const double of_walls = share_of(altered.points, [&](const Point2& point) {
    return std::any_of(plan.walls.begin(), plan.walls.end(), [&](const Polygon& wall) {
      return distance_m(wall, point) <= options.wall_reach_m;
    });
  });
  const Extent extent = extent_of(altered.points);
  if (of_walls > (thing.piece ? most : 0.5) && extent.length_m >= options.shortest_wall_m &&
      extent.width_m <= options.longest_across_m) {
    return {ThingKind::wall, 0, {}};
  }
  return thing;
}

}  // namespace roomatlas::changes
