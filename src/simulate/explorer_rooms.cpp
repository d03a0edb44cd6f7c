// SPDX-License-Identifier: GPL-3.0-or-later
#include "explorer_rooms.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

namespace roomatlas {
namespace {

constexpr double kSameDoorM = 0.6;   // doorways whose middles are nearer are one
constexpr double kClosedM = 0.075;   // half the breadth of a closed door
constexpr double kJambReachM = 0.1;  // it is closed into its jambs
constexpr double kZoneM = 0.3;       // half the breadth of a door's zone
constexpr int kMaxFailures = 2;      // to reach a door; then it is left

Segment2 longer(const Segment2& segment, double by_m) {
  const Point2 along = (segment.b - segment.a).normalized();
  return {segment.a - by_m * along, segment.b + by_m * along};
}

}  // namespace

bool ExplorerRooms::add(const Doorway& doorway, const Point2& viewer) {
  const Point2 middle = doorway.frame_from_pivot.position();
  for (const KnownDoor& known : doors_) {
    if ((known.doorway.frame_from_pivot.position() - middle).norm() < kSameDoorM) return false;
  }
  KnownDoor door{doorway, {}, {}, 0};
  const bool viewer_is_ahead = (inverse(doorway.frame_from_pivot) * viewer).x() > 0.0;
  (viewer_is_ahead ? door.ahead : door.behind) = current_;
  const Segment2 line = longer(doorway.jambs, kJambReachM);
  const Point2 reach = Point2::Constant(kClosedM);
  const Cell low = frame_.cell_of(line.a.cwiseMin(line.b) - reach);
  const Cell high = frame_.cell_of(line.a.cwiseMax(line.b) + reach);
  for_each_cell({low, {high.x + 1, high.y + 1}}, [&](const Cell& cell) {
    if (distance(line, frame_.center_of(cell)) <= kClosedM) closed_[key_of(cell)] = doors_.size();
  });
  doors_.push_back(door);
  return true;
}

std::optional<ExplorerRooms::Door> ExplorerRooms::door_at(const Point2& point) const {
  for (Door door = 0; door < doors_.size(); ++door) {
    if (distance(doors_[door].doorway.jambs, point) <= kZoneM) return door;
  }
  return std::nullopt;
}

bool ExplorerRooms::is_closed(const Cell& cell, std::optional<Door> open) const {
  const auto found = closed_.find(key_of(cell));
  return found != closed_.end() && found->second != open;
}

double ExplorerRooms::beyond_m(Door door, const Point2& point) const {
  const KnownDoor& known = doors_[door];
  const double ahead_m = (inverse(known.doorway.frame_from_pivot) * point).x();
  return known.behind == current_ ? ahead_m : -ahead_m;
}

bool ExplorerRooms::is_untaken(const KnownDoor& door) const {
  return (!door.ahead || !door.behind) && door.failures < kMaxFailures;
}

std::vector<ExplorerRooms::Door> ExplorerRooms::untaken() const {
  std::vector<Door> found;
  for (Door door = 0; door < doors_.size(); ++door) {
    if (is_here(door) && is_untaken(doors_[door])) found.push_back(door);
  }
  return found;
}

std::optional<ExplorerRooms::Door> ExplorerRooms::way_back() const {
  std::vector<std::optional<Door>> first(count());
  std::vector<bool> seen(count(), false);
  std::queue<Room> queue({current_});
  seen[current_] = true;
  while (!queue.empty()) {
    const Room room = queue.front();
    queue.pop();
    for (Door door = 0; door < doors_.size(); ++door) {
      const KnownDoor& known = doors_[door];
      if (known.ahead != room && known.behind != room) continue;
      if (room != current_ && is_untaken(known)) return first[room];
      if (!known.ahead || !known.behind || known.failures >= kMaxFailures) continue;
      const Room next = known.ahead == room ? *known.behind : *known.ahead;
      if (seen[next]) continue;
      seen[next] = true;
      first[next] = room == current_ ? door : first[room];
      queue.push(next);
    }
  }
  return std::nullopt;
}

}  // namespace roomatlas
