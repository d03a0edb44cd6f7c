// SPDX-License-Identifier: GPL-3.0-or-later
#include "number_text.hpp"
#include "roomatlas/planar/heal.hpp"
#include "roomatlas/planar/union.hpp"
#include "roomatlas/simulate/world.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace roomatlas {
namespace {

constexpr double kLeastOverlap_m2 = 0.1;    // of two rooms; less is careless drawing
constexpr std::size_t kNamesListed = 5;     // in a message
constexpr int kOverlapsListed = 100;        // of a world that lies on itself all over
constexpr std::size_t kComparedARoom = 40;  // rooms near a room, in the mean: no building has more

std::string title_of(const PlanRoom& room) {
  const std::string number = std::to_string(room.id);
  return "room " + number +
         (room.name.empty() || room.name == number ? "" : " \"" + room.name + "\"");
}

Box2 bounds_of(const PlanRoom& room) {
  Box2 box;
  for (const Polygon& part : room.parts) {
    for (const Point2& corner : part.outer) box.extend(corner);
  }
  return box;
}

bool are_apart(const Box2& a, const Box2& b) {
  return (a.min.array() >= b.max.array()).any() || (b.min.array() >= a.max.array()).any();
}

constexpr std::size_t kFewCrossings = 200;

/// Crosses itself, and does not only touch: rooms of a raster do, where two of their cells meet at
/// a corner. Stops once there are too many.
bool has_many_crossings(const Ring& ring) {
  constexpr double kEnd = 1e-6;
  const auto edge = [&](std::size_t i) { return Segment2{ring[i], ring[(i + 1) % ring.size()]}; };
  std::size_t count = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    for (std::size_t k = i + 2; k < ring.size(); ++k) {
      const std::optional<double> at = crossing_fraction(edge(i), edge(k));
      if (at && *at > kEnd && *at < 1.0 - kEnd && ++count > kFewCrossings) return true;
    }
  }
  return false;
}

/// With so many crossings that a search for all of them might not end.
bool is_scribble(const PlanRoom& room) {
  return std::any_of(room.parts.begin(), room.parts.end(), [](const Polygon& part) {
    return part.outer.size() > kFewCrossings && !planar::is_simple(part) &&
           has_many_crossings(part.outer);
  });
}

/// Rooms are compared two by two, until that would take more than a building does.
void check_overlaps(const FloorPlan& world, Issues& issues) {
  std::vector<Box2> boxes;
  for (const PlanRoom& room : world.rooms) {
    const bool is_comparable = !is_scribble(room);
    boxes.push_back(is_comparable ? bounds_of(room) : Box2());
    if (is_comparable) continue;
    issues.push_back({Severity::error, "", 0, title_of(room),
                      "has an outline that crosses itself: draw it without crossings"});
  }
  std::size_t compared = 0;
  int listed = 0;
  for (std::size_t i = 0; i < world.rooms.size(); ++i) {
    for (std::size_t j = i + 1; j < world.rooms.size(); ++j) {
      if (are_apart(boxes[i], boxes[j])) continue;
      if (listed == kOverlapsListed || ++compared > kComparedARoom * world.rooms.size()) {
        issues.push_back({Severity::error, "", 0, "rooms",
                          "lie on one another all over: not all were compared; expected the rooms "
                          "of one floor, side by side"});
        return;
      }
      const double common_m2 = overlap_area(world.rooms[i].parts, world.rooms[j].parts);
      if (common_m2 <= kLeastOverlap_m2) continue;
      ++listed;
      issues.push_back({Severity::error, "", 0, title_of(world.rooms[i]),
                        "overlaps " + title_of(world.rooms[j]) + " on " + number_text(common_m2) +
                            " m2: move or cut one of the two outlines"});
    }
  }
}

/// The rooms that doors join, as lists of places in `world.rooms`; those with most rooms first.
std::vector<std::vector<std::size_t>> joined_rooms(const FloorPlan& world) {
  std::map<RoomId, std::size_t> place;
  std::vector<std::size_t> group(world.rooms.size());
  for (std::size_t i = 0; i < group.size(); ++i) place[world.rooms[i].id] = group[i] = i;
  const auto root = [&](std::size_t i) {
    while (group[i] != i) i = group[i] = group[group[i]];
    return i;
  };
  for (const PlanDoor& door : world.doors) {
    if (!door.room_a || !door.room_b) continue;
    const auto a = place.find(*door.room_a);
    const auto b = place.find(*door.room_b);
    if (a != place.end() && b != place.end()) group[root(a->second)] = root(b->second);
  }
  std::map<std::size_t, std::vector<std::size_t>> members;
  for (std::size_t i = 0; i < group.size(); ++i) members[root(i)].push_back(i);
  std::vector<std::vector<std::size_t>> groups;
  groups.reserve(members.size());
  for (auto& [unused, rooms] : members) groups.push_back(std::move(rooms));
  std::sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) {
    return a.size() != b.size() ? a.size() > b.size() : a.front() < b.front();
  });
  return groups;
}

void check_closed_off(const FloorPlan& world, Issues& issues) {
  const auto groups = joined_rooms(world);
  for (std::size_t g = 1; g < groups.size(); ++g) {
    std::string names;
    for (std::size_t i = 0; i < std::min(groups[g].size(), kNamesListed); ++i) {
      names += (i > 0 ? ", " : "") + title_of(world.rooms[groups[g][i]]);
    }
    if (groups[g].size() > kNamesListed) {
      names += " and " + std::to_string(groups[g].size() - kNamesListed) + " more";
    }
    issues.push_back(
        {Severity::warning, "", 0, names,
         "closed off: no door leads there from the other rooms, so a robot that starts "
         "elsewhere does not get in; add a door with both rooms, or leave it out"});
  }
}

void check_doors(const FloorPlan& world, Issues& issues) {
  if (world.doors.empty()) {
    issues.push_back({Severity::note, "", 0, "doors",
                      "the world has none: a robot explores the one space that it starts in"});
    return;
  }
  for (const PlanDoor& door : world.doors) {
    if (door.room_a || door.room_b) continue;
    issues.push_back({Severity::warning, "", 0, "door " + std::to_string(door.id),
                      "joins no room: name the rooms on its two sides in \"rooms\""});
  }
  check_closed_off(world, issues);
}

}  // namespace

Issues check_world(const FloorPlan& world) {
  Issues issues;
  if (world.walls.empty()) {
    issues.push_back({Severity::error, "", 0, "walls",
                      "the world has none, so nothing would stop a robot: add features of the kind "
                      "\"wall\", with gaps where the doors are"});
  }
  check_overlaps(world, issues);
  check_doors(world, issues);
  if (world.rooms.empty()) {
    issues.push_back({Severity::note, "", 0, "rooms",
                      "the world has none: a result cannot be compared with it room by room"});
  }
  std::stable_sort(issues.begin(), issues.end(), [](const Issue& a, const Issue& b) {
    return static_cast<int>(a.severity) > static_cast<int>(b.severity);
  });
  return issues;
}

void require_sound(const FloorPlan& world) {
  std::string errors;
  for (const Issue& issue : check_world(world)) {
    if (issue.severity == Severity::error)
      errors += (errors.empty() ? "" : "\n") + to_string(issue);
  }
  if (!errors.empty()) throw InputError(errors);
}

}  // namespace roomatlas
