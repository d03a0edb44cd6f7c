// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/simulate/furnish.hpp"

#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "furnish_leaves.hpp"
#include "furnish_room.hpp"
#include "roomatlas/core/issue.hpp"

namespace roomatlas {
namespace {

void require(bool holds, const std::string& what) {
  if (!holds) throw UsageError("furnish: expected " + what);
}

void require_sound(const FurnishOptions& options) {
  const auto within = [](double value, double low, double high) {
    return value >= low && value <= high;  // false for a NaN too
  };
  require(within(options.footprint.length_m, 0.01, 10.0), "footprint.length_m in [0.01, 10]");
  require(within(options.footprint.width_m, 0.01, 10.0), "footprint.width_m in [0.01, 10]");
  require(within(options.amount, 0.0, 10.0), "amount in [0, 10]");
  require(within(options.open_doors_share, 0.0, 1.0), "open_doors_share in [0, 1]");
  require(within(options.door_clearance_m, 0.0, 10.0), "door_clearance_m in [0, 10]");
  require(within(options.way_width_m, 0.0, 10.0), "way_width_m in [0, 10]");
  require(within(options.route_clearance_m, 0.0, 10.0), "route_clearance_m in [0, 10]");
  for (const Point2& point : options.route) require(point.allFinite(), "a route of finite places");
}

}  // namespace

FloorPlan furnished(FloorPlan world, std::uint64_t seed, const FurnishOptions& options) {
  require_sound(options);
  if (world.rooms.empty()) {
    throw InputError("world: has no rooms to furnish: name them, in a picture with room labels");
  }
  FurnishSite site(world, options);
  std::map<RoomId, RoomWays> ways;
  {
    const ObstacleIndex standing(world);
    for (const PlanRoom& room : world.rooms) {
      ways.try_emplace(room.id, world, room, standing, options);
    }
  }
  open_some_doors(world, seed, options.open_doors_share, site, ways);
  for (const PlanRoom& room : world.rooms) {
    RandomStream random(seed, "furniture of room " + std::to_string(room.id));
    const Inventory inventory = inventory_of(room, options.amount, random);
    RoomFurnisher(room, options, site, ways.at(room.id), world.furniture, random).put(inventory);
  }
  return world;
}

}  // namespace roomatlas
