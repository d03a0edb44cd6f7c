// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/join_rooms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace roomatlas {
namespace {

constexpr std::array kOff_m = {0.4, 0.7, 1.0};  // where the floor on a side is measured
constexpr double kStep_m = 0.05;
constexpr double kBeyond_m = 0.5;   // of wall beyond a jamb
constexpr double kBand_m = 0.1;     // off the opening's line
constexpr double kBeside_m = 0.3;   // floor beside it: the middle of a block is no wall

bool is_free(const Occupancy& bare, const Point2& at) {
  return bare.free.at(bare.frame.cell_of(at));
}

/// How far the floor reaches from a point, up to `most_m`.
double reach_m(const Occupancy& bare, const Point2& from, const Point2& along, double most_m) {
  double off_m = 0.0;
  while (off_m < most_m && is_free(bare, from + off_m * along)) off_m += kStep_m;
  return off_m;
}

/// Whether the floor on one side is wider than the opening, everywhere near it.
bool widens(const Occupancy& bare, const Segment2& jambs, const Point2& across, double by_m) {
  const Point2 middle = (jambs.a + jambs.b) / 2.0;
  const double width_m = (jambs.b - jambs.a).norm();
  const Point2 along = (jambs.b - jambs.a) / width_m;
  const double most_m = width_m / 2.0 + by_m + kStep_m;
  return std::all_of(kOff_m.begin(), kOff_m.end(), [&](double off_m) {
    const Point2 at = middle + off_m * across;
    return reach_m(bare, at, along, most_m) + reach_m(bare, at, -along, most_m) >= width_m + by_m;
  });
}

/// The share of the first stretch beyond a jamb that is wall with floor beside it.
double wall_beyond(const Occupancy& bare, const Point2& jamb, const Point2& along) {
  const Point2 across(-along.y(), along.x());
  int wall = 0;
  int all = 0;
  for (double on_m = kStep_m; on_m <= kBeyond_m; on_m += kStep_m) {
    ++all;
    bool is_wall = false;
    bool is_beside = false;
    for (double off_m = -kBand_m - kBeside_m; off_m <= kBand_m + kBeside_m; off_m += kStep_m / 2.0) {
      const bool free = is_free(bare, jamb + on_m * along + off_m * across);
      if (std::abs(off_m) <= kBand_m) is_wall = is_wall || !free;
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
  const Point2 along = (jambs.b - jambs.a) / width_m;
  const Point2 across(-along.y(), along.x());
  if (widens(bare, jambs, across, options.widening_m) &&
      widens(bare, jambs, -across, options.widening_m)) {
    return true;
  }
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
  std::map<RoomId, RoomId> joined;
  for (const Opening& opening : partition.openings) {
    if (parts(bare, opening, options)) continue;
    const RoomId a = root_of(joined, opening.room_a);
    const RoomId b = root_of(joined, opening.room_b);
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
    opening.room_a = root_of(joined, opening.room_a);
    opening.room_b = root_of(joined, opening.room_b);
  }
  std::erase_if(partition.openings,
                [](const Opening& opening) { return opening.room_a == opening.room_b; });
}

}  // namespace roomatlas
