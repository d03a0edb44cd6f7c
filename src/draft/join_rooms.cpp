// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/join_rooms.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "roomatlas/draft/wall_gaps.hpp"

namespace roomatlas {
namespace {

constexpr double kOpeningStep_m = 0.05;
constexpr double kBeyondJamb_m = 0.5;   // of wall beyond a jamb
constexpr double kOpeningBand_m = 0.1;  // off the opening's line
constexpr double kBeside_m = 0.3;       // floor beside it: the middle of a block is no wall

bool is_free(const Occupancy& bare, const Point2& at) {
  return bare.free.at(bare.frame.cell_of(at));
}

/// The share of the first stretch beyond a jamb that is wall with floor beside it.
double wall_beyond(const Occupancy& bare, const Point2& jamb, const Point2& along) {
  const Point2 across(-along.y(), along.x());
  int wall = 0;
  int all = 0;
  for (double on_m = kOpeningStep_m; on_m <= kBeyondJamb_m; on_m += kOpeningStep_m) {
    ++all;
    bool is_wall = false;
    bool is_beside = false;
    for (double off_m = -kOpeningBand_m - kBeside_m; off_m <= kOpeningBand_m + kBeside_m;
         off_m += kOpeningStep_m / 2.0) {
      const bool free = is_free(bare, jamb + on_m * along + off_m * across);
      if (std::abs(off_m) <= kOpeningBand_m) is_wall = is_wall || !free;
      is_beside = is_beside || free;
    }
    if (is_wall && is_beside) ++wall;
  }
  return static_cast<double>(wall) / all;
}

bool parts(const Occupancy& bare, const Opening& opening, const JoinRoomsOptions& options) {
  const Segment2& jambs = opening.jambs;
  const double width_m = (jambs.b - jambs.a).norm();
  if (width_m <= options.widest_sure_m) return true;
  if (opening.probability >= options.sure_probability) return true;
  const Point2 along = (jambs.b - jambs.a) / width_m;
  const Point2 across(-along.y(), along.x());
  const bool left = widens(bare.free, bare.frame, jambs, across, options.widening_m);
  const bool right = widens(bare.free, bare.frame, jambs, -across, options.widening_m);
  if (left && right) return true;
  if (!left && !right) return false;  // a cut across a corridor
  return std::min(wall_beyond(bare, jambs.a, -along), wall_beyond(bare, jambs.b, along)) >=
         options.wall_share;
}

/// The smallest number of the rooms that each is joined with.
RoomId root_of(std::map<RoomId, RoomId>& joined, RoomId room) {
  while (joined.contains(room) && joined[room] != room) room = joined[room];
  return room;
}

}  // namespace

void join_rooms(const Occupancy& bare, const JoinRoomsOptions& options, RoomPartition& partition) {
  join_rooms([&](const Opening& opening) { return parts(bare, opening, options); }, partition);
}

void join_rooms(const std::function<bool(const Opening&)>& parts, RoomPartition& partition) {
  std::map<RoomId, RoomId> joined;
  for (const Opening& opening : partition.openings) {
    if (parts(opening)) continue;
    const RoomId a = root_of(joined, *opening.room_a);
    const RoomId b = root_of(joined, *opening.room_b);
    joined[std::max(a, b)] = std::min(a, b);
  }
  if (joined.empty()) return;
  for (std::int32_t& room : partition.room_of_cell.values) {
    if (room > 0) room = static_cast<std::int32_t>(root_of(joined, room));
  }
  for (RoomId& room : partition.room_of_pose) {
    if (room > 0) room = root_of(joined, room);
  }
  for (Opening& opening : partition.openings) {
    opening.room_a = root_of(joined, *opening.room_a);
    opening.room_b = root_of(joined, *opening.room_b);
  }
  std::erase_if(partition.openings,
                [](const Opening& opening) { return opening.room_a == opening.room_b; });
}

}  // namespace roomatlas
