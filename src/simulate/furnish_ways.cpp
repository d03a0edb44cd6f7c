// SPDX-License-Identifier: GPL-3.0-or-later
#include "furnish_ways.hpp"

#include "obstacles.hpp"
#include "roomatlas/grid/polygon_cells.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr double kCellM = 0.05;         // larger overlooks narrow ways
constexpr double kDoorwayM = 0.6;       // of floor around a door line that belongs to both rooms
constexpr double kDoorMiddleM = 0.1;    // ways lead to there
constexpr double kLeastPlaceM2 = 0.25;  // smaller places need no wide way; less leaves out more
constexpr double kRimM = 1.0;           // around the room's box

CellBox box_of(const PlanRoom& room, const CellFrame& frame) {
  Box2 bound;
  for (const Polygon& part : room.parts) {
    for (const Point2& corner : part.outer) bound.extend(corner);
  }
  if (bound.empty()) return {};
  const Cell low = frame.cell_of(bound.min - Point2::Constant(kRimM));
  const Cell high = frame.cell_of(bound.max + Point2::Constant(kRimM));
  return {low, {high.x + 1, high.y + 1}};
}

bool leads_to(const PlanDoor& door, RoomId room) {
  return door.kind != DoorKind::window && (door.room_a == room || door.room_b == room);
}

}  // namespace

RoomWays::RoomWays(const FloorPlan& world, const PlanRoom& room, const ObstacleIndex& standing,
                   const FurnishOptions& options)
    : frame_{kCellM},
      box_(box_of(room, frame_)),
      turning_m_(std::hypot(options.footprint.length_m, options.footprint.width_m) / 2.0),
      flags_(box_.count(), 0),
      places_(box_.count(), -1),
      seen_(box_.count(), 0) {
  mark_floor(world, room);
  close_bodies(world);
  const Point2 low = frame_.center_of(box_.min);
  const Point2 high = frame_.center_of(box_.max);
  const double reach_m = (high - low).norm() / 2.0 + turning_m_;
  for (const Segment2& edge : standing.within((low + high) / 2.0, reach_m).edges) {
    close_near(edge, turning_m_);
  }
  number_places();
}

void RoomWays::mark_floor(const FloorPlan& world, const PlanRoom& room) {
  const CellBox inside{{box_.min.x + 1, box_.min.y + 1}, {box_.max.x - 1, box_.max.y - 1}};
  const auto open = [&](const Cell& cell) {
    if (inside.contains(cell)) flags_[box_.index_of(cell)] |= kCanTurn | kOnWay;
  };
  for (const Polygon& part : room.parts) for_each_cell_in(part, frame_, box_, open);
  for (const PlanDoor& door : world.doors) {
    if (!leads_to(door, room.id)) continue;
    const Point2 middle = (door.jambs.a + door.jambs.b) / 2.0;
    for_each_cell(cells_around({door.jambs.a, door.jambs.b}, kDoorwayM, frame_, box_),
                  [&](const Cell& cell) {
                    const Point2 at = frame_.center_of(cell);
                    if (distance(door.jambs, at) <= kDoorwayM) open(cell);
                    if ((at - middle).norm() > kDoorMiddleM) return;
                    flags_[box_.index_of(cell)] |= kAtDoor;
                  });
  }
}

void RoomWays::close_near(const Segment2& edge, double radius_m) {
  for_each_cell(cells_around({edge.a, edge.b}, radius_m, frame_, box_), [&](const Cell& cell) {
    if (distance(edge, frame_.center_of(cell)) < radius_m) flags_[box_.index_of(cell)] = 0;
  });
}

/// The insides: their edges alone would leave the middle of a large piece open.
void RoomWays::close_bodies(const FloorPlan& world) {
  for (const Polygon& body : bodies_of(world)) {
    for_each_cell_in(body, frame_, box_,
                     [&](const Cell& cell) { flags_[box_.index_of(cell)] = 0; });
  }
}

void RoomWays::number_places() {
  ++search_;
  for (std::size_t i = 0; i < flags_.size(); ++i) {
    if ((flags_[i] & kCanTurn) == 0 || seen_[i] == search_) continue;
    flood(i, kCanTurn, [&](std::size_t cell) { places_[cell] = place_count_; });
    ++place_count_;
  }
}

template <typename Visit>
void RoomWays::flood(std::size_t start, std::uint8_t flag, Visit visit) {
  const auto width = static_cast<std::size_t>(box_.width());
  const auto reach = [&](std::size_t cell) {
    if ((flags_[cell] & flag) == 0 || seen_[cell] == search_) return;
    seen_[cell] = search_;
    open_.push_back(cell);
  };
  reach(start);
  while (!open_.empty()) {
    const std::size_t cell = open_.back();
    open_.pop_back();
    visit(cell);
    // The box's rim is closed, so that every cell that is reached has four neighbours.
    for (const std::size_t next : {cell - 1, cell + 1, cell - width, cell + width}) reach(next);
  }
}

/// Whether of each place one connected piece at most is left; smaller ones than `least_cells`
/// do not count unless a door is in them.
bool RoomWays::hangs_together(std::uint8_t flag, std::size_t least_cells) {
  ++search_;
  std::vector<bool> is_found(static_cast<std::size_t>(place_count_), false);
  for (std::size_t i = 0; i < flags_.size(); ++i) {
    if ((flags_[i] & flag) == 0 || seen_[i] == search_) continue;
    std::size_t cells = 0;
    bool at_door = false;
    flood(i, flag, [&](std::size_t cell) {
      ++cells;
      at_door = at_door || (flags_[cell] & kAtDoor) != 0;
    });
    if (cells < least_cells && !at_door) continue;
    const auto place = static_cast<std::size_t>(places_[i]);
    if (is_found[place]) return false;
    is_found[place] = true;
  }
  return true;
}

bool RoomWays::add(const Ring& outline, double way_clearance_m) {
  std::vector<std::pair<std::size_t, std::uint8_t>> before;
  const double reach_m = std::max(turning_m_, way_clearance_m);
  for_each_cell(cells_around(outline, reach_m, frame_, box_), [&](const Cell& cell) {
    const Point2 at = frame_.center_of(cell);
    const double away_m = contains(outline, at) ? 0.0 : distance_to_boundary(outline, at);
    std::uint8_t& flags = flags_[box_.index_of(cell)];
    const std::uint8_t closed = static_cast<std::uint8_t>((away_m < turning_m_ ? kCanTurn : 0) |
                                                          (away_m < reach_m ? kOnWay : 0));
    if ((flags & closed) == 0) return;
    before.emplace_back(box_.index_of(cell), flags);
    flags = static_cast<std::uint8_t>(flags & ~closed);
  });
  const auto least = static_cast<std::size_t>(kLeastPlaceM2 / (kCellM * kCellM));
  if (hangs_together(kCanTurn, 1) && hangs_together(kOnWay, least)) return true;
  for (const auto& [cell, flags] : before) flags_[cell] = flags;
  return false;
}

}  // namespace roomatlas
