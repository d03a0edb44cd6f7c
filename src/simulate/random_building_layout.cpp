// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_building_layout.hpp"

#include "random_stream.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace roomatlas::random_building_layout {
namespace {

// Blocks have this many or, so that all are equal, fewer.
constexpr std::int64_t kRoomsPerBlock = 20;
constexpr double kPitchM = 5.2;       // mean width of a room with its wall
constexpr double kLeastWidthM = 2.4;  // of a room; a door and wall on both sides of it fit in
constexpr double kLinkWidthM = 2.2;   // of the room that leads to the next row of blocks
constexpr double kDepthsM = 11.0;     // of the rooms on both sides together
constexpr double kLeastDepthM = 4.3;  // of one side
constexpr double kDoorMarginM = 0.6;  // from the jamb to the corner: a door needs wall beside it
constexpr double kPassageM = 0.95;    // width of doors between blocks
constexpr double kStripM = kDepthsM + kCorridorM + 3.0 * kWallM;  // rooms, corridor, rooms
constexpr double kHall_m2 = 60.0;                                 // larger rooms are halls
constexpr double kJoinedShare = 0.35;  // of rooms that may have a door to the one before ...
constexpr double kInnerShare = 0.2;    // ... and of these, with none to the corridor

/// How wide rooms are: a kind for each share of them, evenly between two widths.
struct WidthsOfKind {
  double up_to;  // of all rooms
  double low_m;
  double high_m;
};
constexpr WidthsOfKind kOffice{0.65, 3.0, 4.5};      // most rooms
constexpr WidthsOfKind kLaboratory{0.92, 5.0, 8.0};  // about a quarter
constexpr WidthsOfKind kHall{1.0, 9.0, 13.0};        // the rest
constexpr double kLeastDoorM = 0.8;                  // width of doors inside a block ...
constexpr double kMostDoorM = 1.0;                   // ... evenly between these

double between(RandomStream& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

/// Inner width of a room before the row is fitted to its block.
double drawn_width_m(RandomStream& random) {
  const double share = random.uniform();
  for (const WidthsOfKind& kind : {kOffice, kLaboratory}) {
    if (share < kind.up_to) return between(random, kind.low_m, kind.high_m);
  }
  return between(random, kHall.low_m, kHall.high_m);
}

/// Widths that fill a row; none is under the least.
std::vector<double> widths_m(RandomStream& random, std::size_t count, double available_m) {
  std::vector<double> widths;
  double spare_m = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    widths.push_back(drawn_width_m(random));
    spare_m += widths.back() - kLeastWidthM;
  }
  const double scale = (available_m - kLeastWidthM * static_cast<double>(count)) / spare_m;
  for (double& width : widths) width = kLeastWidthM + scale * (width - kLeastWidthM);
  return widths;
}

double door_width_m(RandomStream& random) { return between(random, kLeastDoorM, kMostDoorM); }

/// Where a door's middle may be between two corners.
double door_place(RandomStream& random, double low, double high, double width_m) {
  const double margin = std::min(kDoorMarginM + width_m / 2.0, (high - low) / 2.0);
  return between(random, low + margin, high - margin);
}

void add_door(Block& block, std::size_t from, std::size_t to, const Pose2& out, double width_m) {
  Space& a = block.spaces[from];
  Space& b = block.spaces[to];
  a.openings.push_back({out, width_m, b.id});
  b.openings.push_back({out * Pose2{0.0, 0.0, wrap_angle(kPi)}, width_m, a.id});
  block.doors.push_back({a.id, a.openings.back()});
}

RoomKind kind_of(const Box2& box) {
  return box.size().prod() > kHall_m2 ? RoomKind::hall : RoomKind::room;
}

}  // namespace

const LaidOpening* opening_to(const Space& space, RoomId beyond) {
  const auto at =
      std::find_if(space.openings.begin(), space.openings.end(),
                   [&](const LaidOpening& opening) { return opening.beyond == beyond; });
  return at == space.openings.end() ? nullptr : &*at;
}

Layout::Layout(std::int64_t rooms, std::uint64_t seed)
    : rooms_(rooms), seed_(seed), blocks_((rooms + kRoomsPerBlock - 1) / kRoomsPerBlock) {
  const std::int64_t largest = (rooms_ + blocks_ - 1) / blocks_;
  width_m_ = kPitchM * static_cast<double>(std::max<std::int64_t>(2, largest / 2));
  columns_ = std::max<std::int64_t>(
      1, std::llround(std::sqrt(static_cast<double>(blocks_) * kStripM / width_m_)));
}

std::optional<std::int64_t> Layout::index_at(std::int64_t strip, std::int64_t column) const {
  if (strip < 0 || column < 0 || column >= columns_) return std::nullopt;
  const std::int64_t index =
      strip * columns_ + (heading_of(strip) > 0 ? column : columns_ - 1 - column);
  return index < blocks_ ? std::optional(index) : std::nullopt;
}

/// Blocks differ by one room at most. Written so that it does not overflow.
RoomId Layout::first_room(std::int64_t index) const {
  const std::int64_t whole = rooms_ / blocks_;
  const std::int64_t rest = rooms_ % blocks_;
  return 1 + index * whole + std::min(index, rest);
}

RoomId Layout::link_room(std::int64_t index, bool north) const {
  const RoomId corridor = first_room(index);
  const std::int64_t southern = (first_room(index + 1) - corridor - 1) / 2;
  return corridor + 1 + (north ? southern : 0);
}

bool Layout::link_is_left(std::int64_t column) const {
  return RandomStream(seed_, "building column " + std::to_string(column)).uniform() < 0.5;
}

double Layout::southern_depth_m(std::int64_t strip) const {
  RandomStream random(seed_, "building strip " + std::to_string(strip));
  return between(random, kLeastDepthM, kDepthsM - kLeastDepthM);
}

/// One side of a corridor.
struct Layout::Row {
  bool is_north = false;
  std::size_t count = 0;
  double low_y = 0.0;
  double high_y = 0.0;
  RandomStream& random;
};

void Layout::add_row(Block& block, const Row& row) const {
  if (row.count == 0) return;
  const int heading = heading_of(block.strip);
  const double min_x = block.corridor().box.min.x();
  const double max_x = block.corridor().box.max.x();
  const bool link_left = link_is_left(block.column);
  const double front_y = row.is_north ? row.low_y - kWallM / 2.0 : row.high_y + kWallM / 2.0;
  const Pose2 to_corridor{0.0, front_y, radians(row.is_north ? -90.0 : 90.0)};
  const auto add_space = [&](double low_x, double high_x) {
    const Box2 box{{low_x, row.low_y}, {high_x, row.high_y}};
    block.spaces.push_back({block.spaces.back().id + 1, kind_of(box), box, {}});
    return block.spaces.size() - 1;
  };
  const auto open_to_corridor = [&](std::size_t space) {
    const Box2& box = block.spaces[space].box;
    const double width_m = door_width_m(row.random);
    Pose2 out = to_corridor;
    out.x_m = door_place(row.random, box.min.x(), box.max.x(), width_m);
    add_door(block, space, 0, out, width_m);
  };

  const bool is_alone = row.count == 1;
  const double link_end = is_alone ? max_x : min_x + kLinkWidthM;
  const std::size_t link =
      link_left || is_alone ? add_space(min_x, link_end) : add_space(max_x - kLinkWidthM, max_x);
  (row.is_north ? block.north_link : block.south_link) = link;
  open_to_corridor(link);

  const double taken_m = kLinkWidthM + kWallM;
  const double available_m = width_m_ - taken_m - kWallM * static_cast<double>(row.count - 2);
  double at =
      heading > 0 ? min_x + (link_left ? taken_m : 0.0) : max_x - (link_left ? 0.0 : taken_m);
  bool can_be_joined = false;
  for (const double width :
       is_alone ? std::vector<double>{} : widths_m(row.random, row.count - 1, available_m)) {
    const std::size_t space = heading > 0 ? add_space(at, at + width) : add_space(at - width, at);
    const double wall_x = at - heading * kWallM / 2.0;  // towards the room before
    at += heading * (width + kWallM);
    const bool is_joined = can_be_joined && row.random.uniform() < kJoinedShare;
    const bool is_inner = is_joined && row.random.uniform() < kInnerShare;
    if (is_joined) {
      const double door_m = door_width_m(row.random);
      const double y = door_place(row.random, row.low_y, row.high_y, door_m);
      add_door(block, space - 1, space, {wall_x, y, wrap_angle(heading > 0 ? 0.0 : kPi)}, door_m);
      block.chains.back().push_back(space);
    } else {
      block.chains.push_back({space});
    }
    if (!is_inner) open_to_corridor(space);
    can_be_joined = !is_inner;
  }
}

/// Doors to other blocks: along the corridor, and from link room to link room.
void Layout::add_ends(Block& block) const {
  const Box2 corridor = block.corridor().box;
  const double middle_y = (corridor.min.y() + corridor.max.y()) / 2.0;
  for (const int side : {-1, 1}) {
    const auto beside = index_at(block.strip, block.column + side);
    if (!beside) continue;
    const double x = side < 0 ? corridor.min.x() - kWallM / 2.0 : corridor.max.x() + kWallM / 2.0;
    const LaidOpening opening{
        {x, middle_y, wrap_angle(side < 0 ? kPi : 0.0)}, kPassageM, first_room(*beside)};
    block.spaces.front().openings.push_back(opening);
    if (side > 0) block.doors.push_back({block.corridor().id, opening});
  }
  const auto link = [&](const std::optional<std::size_t>& own, bool north) {
    const auto beyond = index_at(block.strip + (north ? 1 : -1), block.column);
    if (!own || !beyond) return;
    Space& space = block.spaces[*own];
    const double x = (space.box.min.x() + space.box.max.x()) / 2.0;
    const double y = north ? space.box.max.y() + kWallM / 2.0 : space.box.min.y() - kWallM / 2.0;
    space.openings.push_back(
        {{x, y, radians(north ? 90.0 : -90.0)}, kPassageM, link_room(*beyond, !north)});
    if (north) block.doors.push_back({space.id, space.openings.back()});
  };
  link(block.south_link, false);
  link(block.north_link, true);
}

Block Layout::block(std::int64_t index) const {
  Block block;
  block.index = index;
  block.strip = index / columns_;
  const std::int64_t place = index % columns_;
  block.column = heading_of(block.strip) > 0 ? place : columns_ - 1 - place;
  const auto count = static_cast<std::size_t>(first_room(index + 1) - first_room(index));
  RandomStream random(seed_, "building block " + std::to_string(index));

  const double low_x = static_cast<double>(block.column) * (width_m_ + kWallM);
  const double low_y = static_cast<double>(block.strip) * kStripM;
  const double corridor_y = low_y + southern_depth_m(block.strip) + kWallM;
  const double north_y = corridor_y + kCorridorM + kWallM;
  block.spaces.reserve(count);
  block.spaces.push_back({first_room(index),
                          RoomKind::corridor,
                          {{low_x, corridor_y}, {low_x + width_m_, corridor_y + kCorridorM}},
                          {}});
  const std::size_t southern = (count - 1) / 2;
  add_row(block, {false, southern, low_y, corridor_y - kWallM, random});
  add_row(block, {true, count - 1 - southern, north_y, low_y + kStripM - kWallM, random});
  add_ends(block);
  return block;
}

}  // namespace roomatlas::random_building_layout
