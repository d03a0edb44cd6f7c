// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <tuple>

#include "items.hpp"

namespace roomatlas::changes {
namespace {

constexpr double kBeside_m = 0.4;  // from the middle of a wall to the room beside it

/// What a mission says of an alteration, of which the item is one half.
Sighting sighting_of(const Witness& witness, bool stands) {
  return {stands ? witness.hits : 0, stands ? 0 : witness.passes, witness.visits, witness.first_s,
          witness.last_s};
}

void add(const Sighting& more, Sighting& to) {
  const bool is_first = to.visits.empty();
  to.stood += more.stood;
  to.passed += more.passed;
  to.first_s = is_first ? more.first_s : std::min(to.first_s, more.first_s);
  to.last_s = is_first ? more.last_s : std::max(to.last_s, more.last_s);
  std::vector<AsrId> visits;
  std::set_union(to.visits.begin(), to.visits.end(), more.visits.begin(), more.visits.end(),
                 std::back_inserter(visits));
  to.visits = std::move(visits);
}

/// Adds an item to a change.
void add(const Item& item, Change& change) {
  const bool is_new = item.altered.is_new;
  (is_new ? change.appeared : change.gone).push_back(item.outline);
  add(sighting_of(item.altered.before, !is_new), change.before);
  add(sighting_of(item.altered.after, is_new), change.after);
  change.size_m = std::max(change.size_m, item.extent.length_m);
  if (is_new || change.appeared.empty()) change.at = item.extent.middle;
}

Change change_of(ChangeKind kind, const Item& item) {
  Change change;
  change.kind = kind;
  add(item, change);
  return change;
}

ChangeKind kind_of(const Item& item) {
  if (item.thing.kind == ThingKind::wall) {
    return item.altered.is_new ? ChangeKind::wall_new : ChangeKind::wall_gone;
  }
  return item.altered.is_new ? ChangeKind::furniture_new : ChangeKind::furniture_gone;
}

/// A door is shut where something fills it now, opened where something did.
ChangeKind kind_of_door(ChangeKind so_far, const Item& item) {
  if (item.thing.kind != ThingKind::gap) return so_far;
  return item.altered.is_new ? ChangeKind::door_shut : ChangeKind::door_opened;
}

/// The changes of doors: what fills them, and their leaves.
std::vector<Change> door_changes(const std::vector<Item>& items,
                                 const std::vector<DoorPlace>& doors) {
  std::map<std::size_t, Change> changes;
  for (const Item& item : items) {
    if (item.thing.kind != ThingKind::gap && item.thing.kind != ThingKind::leaf) continue;
    const DoorPlace& door = doors[item.thing.door];
    const auto [entry, is_first] = changes.try_emplace(item.thing.door);
    Change& change = entry->second;
    if (is_first) change.kind = ChangeKind::door_turned;
    change.kind = kind_of_door(change.kind, item);
    add(item, change);
    change.at = door.middle();
    change.door = door.old_id;
    change.size_m = door.width_m;
  }
  std::vector<Change> list;
  for (auto& [door, change] : changes) list.push_back(std::move(change));
  return list;
}

/// The changes of all else.
std::vector<Change> other_changes(const std::vector<Item>& items, const ChangeOptions& options) {
  std::vector<Change> changes;
  std::vector<bool> is_told(items.size(), false);
  for (const auto& [gone, appeared] : moved_pairs(items, options)) {
    const bool is_wall = items[gone].thing.kind == ThingKind::wall;
    changes.push_back(
        change_of(is_wall ? ChangeKind::wall_moved : ChangeKind::furniture_moved, items[gone]));
    add(items[appeared], changes.back());
    is_told[gone] = is_told[appeared] = true;
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    const ThingKind kind = items[i].thing.kind;
    if (is_told[i] || kind == ThingKind::gap || kind == ThingKind::leaf) continue;
    changes.push_back(change_of(kind_of(items[i]), items[i]));
  }
  return changes;
}

const PlanRoom* room_at(const FloorPlan& plan, const Point2& at) {
  const auto holds = [&](const PlanRoom& room) {
    return std::any_of(room.parts.begin(), room.parts.end(),
                       [&](const Polygon& part) { return contains(part, at); });
  };
  const auto found = std::find_if(plan.rooms.begin(), plan.rooms.end(), holds);
  return found == plan.rooms.end() ? nullptr : &*found;
}

/// Says in which room of a plan a change lies; of a door in a wall, in one beside it.
void place(Change& change, const FloorPlan& plan) {
  for (const Point2& off : {Point2(0.0, 0.0), Point2(-kBeside_m, 0.0), Point2(0.0, -kBeside_m),
                            Point2(kBeside_m, 0.0), Point2(0.0, kBeside_m)}) {
    const PlanRoom* const room = room_at(plan, change.at + off);
    if (room == nullptr) continue;
    change.room = room->id;
    change.room_name = room->name;
    return;
  }
}

}  // namespace

std::vector<Change> changes_of(const std::vector<Altered>& altered, const FloorPlan& before,
                               const FloorPlan& after, const ChangeOptions& options) {
  const std::vector<DoorPlace> doors = doors_of(before, after);
  const std::vector<Item> items = items_of(altered, before, after, doors, options);
  std::vector<Change> changes = door_changes(items, doors);
  const std::vector<Change> others = other_changes(items, options);
  changes.insert(changes.end(), others.begin(), others.end());
  const auto order = [](const Change& change) {
    const bool is_furniture =
        change.kind >= ChangeKind::furniture_gone && change.kind <= ChangeKind::furniture_moved;
    const bool is_door = change.kind < ChangeKind::furniture_gone;
    return std::tuple(is_door ? 0 : is_furniture ? 2 : 1, change.at.x(), change.at.y());
  };
  std::stable_sort(changes.begin(), changes.end(),
                   [&](const Change& a, const Change& b) { return order(a) < order(b); });
  std::int64_t id = 0;
  for (Change& change : changes) {
    change.id = ++id;
    place(change, before);
  }
  return changes;
}

}  // namespace roomatlas::changes
