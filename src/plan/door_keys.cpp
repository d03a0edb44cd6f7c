// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/plan/door_keys.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace roomatlas {
namespace {

std::string rooms_of(const PlanDoor& door) {
  if (!door.room_a && !door.room_b) return "out-out";
  if (!door.room_a || !door.room_b) {
    return std::to_string(door.room_a.value_or(door.room_b.value_or(0))) + "-out";
  }
  const auto [low, high] = std::minmax(*door.room_a, *door.room_b);
  return std::to_string(low) + "-" + std::to_string(high);
}

/// Along a direction that walls hardly follow: doors in one wall keep their order though it is
/// measured anew, and lies some millimetres off.
double place_of(const PlanDoor& door) {
  return (door.jambs.a + door.jambs.b).dot(Point2(0.8, 0.6));
}

}  // namespace

std::vector<std::string> door_keys(const FloorPlan& plan) {
  std::vector<std::string> keys;
  std::map<std::string, std::vector<std::size_t>> doors_of;
  for (const PlanDoor& door : plan.doors) {
    keys.push_back(rooms_of(door));
    doors_of[keys.back()].push_back(keys.size() - 1);
  }
  for (auto& [rooms, doors] : doors_of) {
    std::stable_sort(doors.begin(), doors.end(), [&](std::size_t i, std::size_t k) {
      return place_of(plan.doors[i]) < place_of(plan.doors[k]);
    });
    for (std::size_t n = 1; n < doors.size(); ++n) keys[doors[n]] += "-" + std::to_string(n + 1);
  }
  return keys;
}

}  // namespace roomatlas
