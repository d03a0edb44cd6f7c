// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/merge/carry_over.hpp"

#include <algorithm>
#include <set>

#include "roomatlas/merge/merge.hpp"
#include "roomatlas/planar/union.hpp"

namespace roomatlas {
namespace {

constexpr double kLeastShare = 0.25;  // of the smaller room; less is a neighbour's edge

Box2 box_of(const PlanRoom& room) {
  Box2 box;
  for (const Polygon& part : room.parts) {
    for (const Point2& point : part.outer) {
      if (point.allFinite()) box.extend(point);
    }
  }
  return box;
}

bool meet(const Box2& a, const Box2& b) {
  return !a.empty() && !b.empty() && (a.min.array() <= b.max.array()).all() &&
         (b.min.array() <= a.max.array()).all();
}

struct Overlap {
  double area_m2 = 0.0;
  std::size_t former = 0;
  std::size_t now = 0;
};

/// All pairs that share enough, the greatest first.
std::vector<Overlap> overlaps_of(const std::vector<PlanRoom>& former,
                                 const std::vector<PlanRoom>& now) {
  std::vector<Overlap> overlaps;
  for (std::size_t i = 0; i < former.size(); ++i) {
    const Box2 box = box_of(former[i]);
    for (std::size_t k = 0; k < now.size(); ++k) {
      if (!meet(box, box_of(now[k]))) continue;
      const double shared_m2 = overlap_area(former[i].parts, now[k].parts);
      const double smaller_m2 = std::min(former[i].area_m2, now[k].area_m2);
      if (shared_m2 > 0.0 && shared_m2 >= kLeastShare * smaller_m2) {
        overlaps.push_back({shared_m2, i, k});
      }
    }
  }
  std::stable_sort(overlaps.begin(), overlaps.end(),
                   [](const Overlap& a, const Overlap& b) { return a.area_m2 > b.area_m2; });
  return overlaps;
}

/// For each room now, its place among the former ones; one to one.
std::vector<std::optional<std::size_t>> matches_of(const std::vector<PlanRoom>& former,
                                                   const std::vector<PlanRoom>& now) {
  std::vector<std::optional<std::size_t>> match(now.size());
  std::vector<bool> is_taken(former.size(), false);
  for (const Overlap& overlap : overlaps_of(former, now)) {
    if (match[overlap.now] || is_taken[overlap.former]) continue;
    match[overlap.now] = overlap.former;
    is_taken[overlap.former] = true;
  }
  return match;
}

std::map<RoomId, RoomId> renumbering_of(const std::vector<PlanRoom>& former,
                                        const std::vector<PlanRoom>& now,
                                        const std::vector<std::optional<std::size_t>>& match) {
  std::map<RoomId, RoomId> number;
  std::set<RoomId> used;
  RoomId highest = 0;
  for (const PlanRoom& room : former) {
    used.insert(room.id);  // the number of a room that is gone is not given to another
    highest = std::max(highest, room.id);
  }
  for (const PlanRoom& room : now) highest = std::max(highest, room.id);
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (match[i]) {
      number[now[i].id] = former[*match[i]].id;
    } else {
      number[now[i].id] = used.insert(now[i].id).second ? now[i].id : ++highest;
    }
  }
  return number;
}

}  // namespace

bool is_named(const PlanRoom& room) { return room.name != std::to_string(room.id); }

void renumber(FloorPlan& plan, const std::map<RoomId, RoomId>& number) {
  const auto follow = [&](std::optional<RoomId>& room) {
    if (room && number.contains(*room)) room = number.at(*room);
  };
  for (PlanDoor& door : plan.doors) {
    follow(door.room_a);
    follow(door.room_b);
    if (door.room_a && door.room_b && *door.room_a > *door.room_b) {
      std::swap(door.room_a, door.room_b);
    }
  }
  for (PlanEdge& edge : plan.edges) {
    if (const auto now = number.find(edge.room); now != number.end()) edge.room = now->second;
  }
  std::stable_sort(plan.edges.begin(), plan.edges.end(),
                   [](const PlanEdge& a, const PlanEdge& b) { return a.room < b.room; });
  for (PlanRoom& room : plan.rooms) {
    const auto now = number.find(room.id);
    if (now == number.end()) continue;
    const bool had_name = is_named(room);
    room.id = now->second;
    if (!had_name) room.name = std::to_string(room.id);
  }
  std::sort(plan.rooms.begin(), plan.rooms.end(),
            [](const PlanRoom& a, const PlanRoom& b) { return a.id < b.id; });
}

CarriedOver carry_over(const std::vector<PlanRoom>& former, FloorPlan& plan,
                       std::map<AsrId, RoomId>& room_of_asr) {
  const auto match = matches_of(former, plan.rooms);
  CarriedOver carried;
  carried.number = renumbering_of(former, plan.rooms, match);
  std::map<RoomId, std::string> name_of;
  std::set<RoomId> found;
  for (const auto& place : match) {
    if (!place) continue;
    const PlanRoom& room = former[*place];
    found.insert(room.id);
    if (is_named(room)) name_of[room.id] = room.name;
  }
  std::set<std::string> given;  // by statements, which are newer
  for (const PlanRoom& room : plan.rooms) {
    if (is_named(room)) given.insert(room.name);
  }
  renumber(plan, carried.number);
  for (PlanRoom& room : plan.rooms) {
    const auto name = name_of.find(room.id);
    if (name == name_of.end() || is_named(room) || given.contains(name->second)) continue;
    room.name = name->second;
  }
  for (auto& [asr, room] : room_of_asr) {
    if (carried.number.contains(room)) room = carried.number.at(room);
  }
  for (const PlanRoom& room : former) {
    if (found.contains(room.id) || !is_named(room) || given.contains(room.name)) continue;
    carried.absent.push_back(room);
    carried.lost.push_back({Severity::warning, "", 0, "room " + std::to_string(room.id),
                            "\"" + room.name +
                                "\" was not found again: its name is kept until it is, or give it "
                                "to the room that it is now with `roomatlas rename`"});
  }
  plan.issues.insert(plan.issues.end(), carried.lost.begin(), carried.lost.end());
  return carried;
}

}  // namespace roomatlas
