// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/simulate/tour.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "roomatlas/core/issue.hpp"
#include "walk_ways.hpp"

namespace roomatlas {
namespace {

constexpr double kCellM = 0.05;             // larger misses doors beside an open leaf
constexpr double kRasterM = 0.71 * kCellM;  // by which the raster's clearance may be wrong
constexpr double kEasyM = 0.5;              // nearer to walls it is steered only where it must

/// A place to be seen from near by.
struct Sight {
  Point2 at;
  std::size_t room = 0;
  bool is_left = true;
};

/// The places of the rooms that the robot gets to; each in the first room that holds it.
std::vector<Sight> sights_of(const FloorPlan& world, const WalkWays& ways) {
  std::vector<std::vector<Box2>> boxes;
  for (const PlanRoom& room : world.rooms) {
    boxes.emplace_back();
    for (const Polygon& part : room.parts) boxes.back().push_back(bounds(part.outer));
  }
  const auto holds = [&](std::size_t room, const Point2& at) {
    for (std::size_t i = 0; i < boxes[room].size(); ++i) {
      const Box2& box = boxes[room][i];
      const bool is_near =
          (at.array() >= box.min.array()).all() && (at.array() <= box.max.array()).all();
      if (is_near && contains(world.rooms[room].parts[i], at)) return true;
    }
    return false;
  };
  std::vector<Sight> sights;
  constexpr int kEvery = 5;  // cells between sights, in each direction
  for (const Point2& at : ways.places()) {
    const auto on_raster = [&](double value) {
      return static_cast<long>(std::floor(value / kCellM)) % kEvery == 0;
    };
    if (!on_raster(at.x()) || !on_raster(at.y())) continue;
    for (std::size_t room = 0; room < world.rooms.size(); ++room) {
      if (!holds(room, at)) continue;
      sights.push_back({at, room});
      break;
    }
  }
  return sights;
}

using Key = std::pair<long, long>;
Key key_of(const Point2& at) {
  return {std::lround(at.x() / kCellM * 2.0), std::lround(at.y() / kCellM * 2.0)};
}

/// Where to go next, with the room of each: what is left of this room; else the middles of the
/// rooms that were not entered yet, and what is left of the others.
std::map<Key, std::size_t> goals_of(const std::vector<Sight>& sights,
                                    const std::vector<std::size_t>& middles,
                                    const std::vector<bool>& is_entered,
                                    std::optional<std::size_t> room) {
  std::map<Key, std::size_t> here;
  std::map<Key, std::size_t> elsewhere;
  for (std::size_t i = 0; i < sights.size(); ++i) {
    if (!sights[i].is_left) continue;
    const std::size_t of = sights[i].room;
    if (room == of) here.emplace(key_of(sights[i].at), of);
    if (is_entered[of] || middles[of] == i) elsewhere.emplace(key_of(sights[i].at), of);
  }
  return here.empty() ? elsewhere : here;
}

/// The sight nearest to each room's label point; of a room without any, none of them.
std::vector<std::size_t> middles_of(const FloorPlan& world, const std::vector<Sight>& sights) {
  std::vector<std::size_t> middles(world.rooms.size(), sights.size());
  std::vector<double> least_m(world.rooms.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < sights.size(); ++i) {
    const std::size_t room = sights[i].room;
    const double away_m = (sights[i].at - world.rooms[room].label_point).norm();
    if (away_m >= least_m[room]) continue;
    least_m[room] = away_m;
    middles[room] = i;
  }
  return middles;
}

}  // namespace

Drive tour(const FloorPlan& world, const Point2& start, const TourOptions& options) {
  if (world.rooms.empty()) throw InputError("world: has no rooms to drive through");
  const double turning_m = std::hypot(options.footprint.length_m, options.footprint.width_m) / 2.0;
  WalkWays ways(world, start, {kCellM, turning_m - kRasterM, kEasyM});
  std::vector<Sight> sights = sights_of(world, ways);
  const std::vector<std::size_t> middles = middles_of(world, sights);
  std::vector<bool> is_entered(world.rooms.size(), false);
  std::optional<std::size_t> room;
  Drive drive = {start};
  for (;;) {
    const auto goals = goals_of(sights, middles, is_entered, room);
    const Polyline way = ways.way_to_nearest(
        drive.back(), [&](const Point2& at) { return goals.contains(key_of(at)); });
    if (way.empty()) break;
    drive.insert(drive.end(), way.begin(), way.end());
    room = goals.at(key_of(way.back()));
    is_entered[*room] = true;
    for (Sight& sight : sights) {
      const bool is_seen = sight.room == *room && (sight.at - way.back()).norm() <= options.view_m;
      if (is_seen) sight.is_left = false;
    }
  }
  if (drive.size() < 2) throw InputError("world: the robot gets nowhere from where it starts");
  return drive;
}

}  // namespace roomatlas
