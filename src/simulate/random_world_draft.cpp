// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_world_draft.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "roomatlas/planar/union.hpp"

namespace roomatlas::random_world_draft {
namespace {

constexpr double kCutM = 0.01;        // by which a door's cut reaches into both rooms
constexpr double kCornerM = 0.2;      // of wall between a door and a corner
constexpr double kLeastDoorM = 0.75;  // a robot of 0.6 m across gets through
constexpr double kMostDoorM = 1.6;
constexpr double kUsualShare = 0.7;  // of buildings with doors of 0.8 to 1 m
constexpr double kUnlikeM = 0.05;    // by which doors of one building differ
constexpr double kInnerShare = 0.2;  // of joined rooms, that have no other door

/// The strip of wall along an edge of a room, on its outer side; at corners it goes on, so that the
/// strips of two edges close them, whatever their angle.
Polygon wall_along(const Segment2& edge, double wall_m) {
  const Point2 along = (edge.b - edge.a).normalized();
  const Point2 out(along.y(), -along.x());
  const Point2 a = edge.a - wall_m * along;
  const Point2 b = edge.b + wall_m * along;
  return {{a + wall_m * out, b + wall_m * out, b, a}, {}};
}

/// @param ring with the room on its left
void add_walls(const Ring& ring, double wall_m, std::vector<Polygon>& walls) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    walls.push_back(wall_along({ring[i], ring[(i + 1) % ring.size()]}, wall_m));
  }
}

Ring oriented(Ring ring, bool counter_clockwise) {
  if ((signed_area(ring) > 0.0) != counter_clockwise) std::reverse(ring.begin(), ring.end());
  return ring;
}

}  // namespace

double between(RandomStream& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

int whole_between(RandomStream& random, int low, int high) {
  return low + static_cast<int>(random.uniform() * (high - low + 1));
}

Style drawn_style(RandomStream& random) {
  Style style;
  style.wall_m = between(random, 0.08, 0.4);
  style.door_m = random.uniform() < kUsualShare ? between(random, 0.8, 1.0)
                                                : between(random, kLeastDoorM, kMostDoorM);
  style.corridor_m = between(random, 1.5, 3.2);
  style.least_width_m = between(random, 2.2, 3.2);
  style.most_width_m = style.least_width_m + between(random, 0.3, 4.5);
  style.depth_m = between(random, 2.8, 6.5);
  style.joined_share = between(random, 0.0, 0.3);
  return style;
}

double drawn_door_m(RandomStream& random, const Style& style, double available_m) {
  const double unlike_m = style.equal ? 0.0 : between(random, -kUnlikeM, kUnlikeM);
  const double most_m = std::min(kMostDoorM, available_m - 2.0 * kCornerM);
  return std::max(kLeastDoorM, std::min(style.door_m + unlike_m, most_m));
}

Ring rectangle(double min_x, double min_y, double max_x, double max_y) {
  return {{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}};
}

std::size_t Draft::add_room(Polygon outline, RoomKind kind) {
  PlanRoom room;
  room.id = static_cast<RoomId>(rooms_.size() + 1);
  room.name = std::to_string(room.id);
  room.kind = kind;
  outline.outer = oriented(std::move(outline.outer), true);
  for (Ring& hole : outline.holes) hole = oriented(std::move(hole), false);
  room.area_m2 = area(outline);
  room.parts = {std::move(outline)};
  rooms_.push_back(std::move(room));
  return rooms_.size() - 1;
}

void Draft::add_door(std::size_t from, std::size_t to, const Pose2& out, double width_m) {
  const double half_m = width_m / 2.0;
  const auto across = [&](double from_x, double to_x) {
    Ring ring = rectangle(from_x, -half_m, to_x, half_m);
    for (Point2& corner : ring) corner = out * corner;
    return ring;
  };
  PlanDoor door;
  door.id = static_cast<std::int64_t>(doors_.size() + 1);
  door.jambs = {out * Point2(wall_m_ / 2.0, half_m), out * Point2(wall_m_ / 2.0, -half_m)};
  door.width_m = width_m;
  door.opening = across(0.0, wall_m_);
  const auto [low, high] = std::minmax(from, to);
  door.room_a = rooms_[low].id;
  door.room_b = rooms_[high].id;
  doors_.push_back(std::move(door));
  openings_.push_back({across(-kCutM, wall_m_ + kCutM), {}});
}

std::vector<Polygon> Draft::walls() const {
  std::vector<Polygon> walls;
  std::vector<Polygon> free = openings_;
  for (const PlanRoom& room : rooms_) {
    const Polygon& outline = room.parts.front();
    add_walls(outline.outer, wall_m_, walls);
    for (const Ring& hole : outline.holes) add_walls(hole, wall_m_, walls);
    free.push_back(outline);
  }
  walls = difference_of(walls, free);
  walls.insert(walls.end(), partitions_.begin(), partitions_.end());
  return walls;
}

FloorPlan Draft::plan(double turned_rad) const {
  const Pose2 turn{0.0, 0.0, wrap_angle(turned_rad)};
  FloorPlan plan;
  plan.rooms = rooms_;
  plan.doors = doors_;
  plan.walls = walls();
  for (Polygon& wall : plan.walls) wall = transformed(turn, wall);
  for (PlanRoom& room : plan.rooms) {
    room.parts.front() = transformed(turn, room.parts.front());
    room.label_point = interior_point(room.parts.front());
  }
  for (PlanDoor& door : plan.doors) {
    door.jambs = transformed(turn, door.jambs);
    door.opening = transformed(turn, door.opening);
  }
  return plan;
}

int rooms_in(double length_m, const Style& style) {
  const double each_m = style.mean_width_m() + style.wall_m;
  return std::max(1, static_cast<int>((length_m + style.wall_m) / each_m));
}

void add_row(Draft& draft, RandomStream& random, const Style& style, const Row& row, int count) {
  std::vector<double> widths_m;
  double sum_m = 0.0;
  for (int i = 0; i < count; ++i) {
    widths_m.push_back(style.equal ? 1.0
                                   : between(random, style.least_width_m, style.most_width_m));
    sum_m += widths_m.back();
  }
  const double scale = (row.length_m - style.wall_m * (count - 1)) / sum_m;
  double from_x = 0.0;
  std::optional<std::size_t> before;
  for (const double drawn_m : widths_m) {
    const double to_x = from_x + scale * drawn_m;
    Ring ring = rectangle(from_x, style.wall_m, to_x, style.wall_m + row.depth_m);
    for (Point2& corner : ring) corner = row.world_from_row * corner;
    const std::size_t room = draft.add_room({ring, {}}, RoomKind::room);
    bool is_inner = false;
    if (before && !style.equal && random.uniform() < style.joined_share) {
      const double width_m = drawn_door_m(random, style, row.depth_m);
      const double spare_m = row.depth_m - width_m - 2.0 * kCornerM;
      const double y = style.wall_m + kCornerM + width_m / 2.0 + spare_m * random.uniform();
      draft.add_door(*before, room, row.world_from_row * Pose2{from_x - style.wall_m, y, 0.0},
                     width_m);
      is_inner = random.uniform() < kInnerShare;
    }
    if (!is_inner) {
      const double width_m = drawn_door_m(random, style, to_x - from_x);
      const double spare_m = std::max(0.0, to_x - from_x - width_m - 2.0 * kCornerM);
      const double x =
          (from_x + to_x) / 2.0 + (style.equal ? 0.0 : spare_m * (random.uniform() - 0.5));
      draft.add_door(row.host, room, row.world_from_row * Pose2{x, 0.0, kPi / 2.0}, width_m);
    }
    before = room;
    from_x = to_x + style.wall_m;
  }
}

std::size_t add_strip(Draft& draft, RandomStream& random, const Style& style, const Strip& strip) {
  const double half_m = style.corridor_m / 2.0;
  Ring ring = rectangle(0.0, -half_m, strip.length_m, half_m);
  for (Point2& corner : ring) corner = strip.world_from_strip * corner;
  const std::size_t corridor = draft.add_room({ring, {}}, RoomKind::corridor);
  const double length_m = strip.length_m - strip.bare_m;
  const Pose2 left{strip.bare_m, half_m, 0.0};
  const Pose2 right{strip.length_m, -half_m, wrap_angle(kPi)};
  const double other_depth_m = style.equal ? style.depth_m : between(random, 2.8, 6.5);
  if (strip.left > 0) {
    add_row(draft, random, style,
            {strip.world_from_strip * left, length_m, style.depth_m, corridor}, strip.left);
  }
  if (strip.right > 0) {
    add_row(draft, random, style,
            {strip.world_from_strip * right, length_m, other_depth_m, corridor}, strip.right);
  }
  return corridor;
}

}  // namespace roomatlas::random_world_draft
