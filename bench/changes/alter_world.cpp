// SPDX-License-Identifier: GPL-3.0-or-later
#include "changes/alter_world.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "roomatlas/simulate/world.hpp"

namespace roomatlas::bench {
namespace {

constexpr int kAttempts = 40;         // at finding a place
constexpr double kApart_m = 0.12;     // from anything else
constexpr double kFromDoors_m = 1.1;  // so that the robot gets through
constexpr double kLeastPiece_m2 = 0.15;

std::vector<Point2> edge_points(const Ring& ring) {
  std::vector<Point2> points;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 side = ring[(i + 1) % ring.size()] - ring[i];
    const int steps = std::max(1, static_cast<int>(side.norm() / 0.05));
    for (int k = 0; k < steps; ++k) points.push_back(ring[i] + side * k / steps);
  }
  return points;
}

bool are_apart(const Polygon& a, const Polygon& b, double apart_m) {
  const auto is_near = [&](const Polygon& body, const Point2& point) {
    if (contains(body, point) || distance_to_boundary(body.outer, point) < apart_m) return true;
    return std::any_of(body.holes.begin(), body.holes.end(), [&](const Ring& hole) {
      return distance_to_boundary(hole, point) < apart_m;
    });
  };
  for (const Point2& point : edge_points(a.outer)) {
    if (is_near(b, point)) return false;
  }
  return !contains(a, b.outer.front());
}

Point2 middle_of(const Ring& ring) {
  Point2 sum = Point2::Zero();
  for (const Point2& point : ring) sum += point;
  return sum / static_cast<double>(ring.size());
}

/// Alters two copies of a world.
class Alterer {
 public:
  Alterer(const FloorPlan& world, Draw& draw) : draw_(draw), done_{world, world, {}} {}

  void alter_something() {
    switch (draw_.whole(0, 6)) {
      case 0:
      case 1:
        return alter_door();
      case 2:
      case 3:
        return move_furniture();
      case 4:
        return remove_furniture();
      default:
        return build_wall();
    }
  }

  AlteredWorld taken() {
    for (FloorPlan* world : {&done_.before, &done_.after}) {
      std::erase_if(world->furniture,
                    [](const PlanFurniture& piece) { return piece.outline.outer.empty(); });
    }
    return std::move(done_);
  }

 private:
  /// Whether all rooms are joined by the doors that are open in both missions, but for one.
  bool is_joined_without(std::size_t closed) const {
    std::set<RoomId> reached;
    const auto& doors = done_.before.doors;
    for (bool grows = true; grows;) {
      grows = false;
      for (std::size_t i = 0; i < doors.size(); ++i) {
        if (i == closed || shut_.contains(i) || !doors[i].room_a || !doors[i].room_b) continue;
        if (reached.empty()) reached.insert(*doors[i].room_a);
        const bool a = reached.contains(*doors[i].room_a);
        const bool b = reached.contains(*doors[i].room_b);
        if (a == b) continue;
        reached.insert({*doors[i].room_a, *doors[i].room_b});
        grows = true;
      }
    }
    return reached.size() == done_.before.rooms.size();
  }

  void alter_door() {
    const auto& doors = done_.before.doors;
    if (doors.empty()) return;
    const auto i = static_cast<std::size_t>(draw_.whole(0, static_cast<int>(doors.size()) - 1));
    const PlanDoor door = doors[i];
    if (shut_.contains(i) || door.kind != DoorKind::door || door.width_m > 1.3) return;
    if (!door.room_a || !door.room_b || !is_joined_without(i)) return;
    const bool is_shut = draw_.happens(0.6);
    (is_shut ? done_.after : done_.before).doors[i].leaf = door.jambs;
    shut_.insert(i);
    const Point2 at = (door.jambs.a + door.jambs.b) / 2.0;
    done_.alterations.push_back({is_shut ? ChangeKind::door_shut : ChangeKind::door_opened,
                                 at,
                                 at,
                                 {*door.room_a, *door.room_b},
                                 {{door.opening, {}}}});
  }

  const PlanRoom* room_at(const Point2& at) const {
    for (const PlanRoom& room : done_.before.rooms) {
      for (const Polygon& part : room.parts) {
        if (contains(part, at)) return &room;
      }
    }
    return nullptr;
  }

  /// A piece that was not altered yet; nothing where luck finds none.
  std::optional<std::size_t> some_piece() {
    const int count = static_cast<int>(done_.before.furniture.size());
    for (int attempt = 0; attempt < kAttempts && count > 0; ++attempt) {
      const auto i = static_cast<std::size_t>(draw_.whole(0, count - 1));
      const Polygon& outline = done_.before.furniture[i].outline;
      if (moved_.contains(i) || outline.outer.empty() || area(outline) < kLeastPiece_m2) continue;
      if (room_at(middle_of(outline.outer)) != nullptr) return i;
    }
    return std::nullopt;
  }

  bool is_clear(const Polygon& body, std::optional<std::size_t> but_for) const {
    for (const FloorPlan* world : {&done_.before, &done_.after}) {
      for (std::size_t i = 0; i < world->furniture.size(); ++i) {
        const Polygon& other = world->furniture[i].outline;
        if (i != but_for && !other.outer.empty() && !are_apart(body, other, kApart_m)) return false;
      }
      for (const PlanDoor& door : world->doors) {
        const Point2 middle = (door.jambs.a + door.jambs.b) / 2.0;
        if (distance_to_boundary(body.outer, middle) < kFromDoors_m) return false;
      }
    }
    const std::vector<Polygon> leaves = open_leaves(done_.before);
    return std::all_of(leaves.begin(), leaves.end(), [&](const Polygon& leaf) {
      return leaf.outer.empty() || are_apart(body, leaf, kApart_m);
    });
  }

  bool is_off_walls(const Polygon& body) const {
    const auto is_off = [&](const Polygon& wall) { return are_apart(body, wall, kApart_m); };
    return std::all_of(done_.before.walls.begin(), done_.before.walls.end(), is_off) &&
           std::all_of(done_.after.walls.begin(), done_.after.walls.end(), is_off);
  }

  void move_furniture() {
    const std::optional<std::size_t> i = some_piece();
    if (!i) return;
    const Polygon piece = done_.before.furniture[*i].outline;
    const Point2 from = middle_of(piece.outer);
    const PlanRoom* room = room_at(from);
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      const Point2 to = from + draw_.between(0.4, 2.5) * direction(draw_.between(-kPi, kPi));
      const double turn_rad = draw_.happens(0.3) ? kPi / 2.0 : draw_.between(-0.2, 0.2);
      const Pose2 moved = Pose2{to.x(), to.y(), turn_rad} * Pose2{-from.x(), -from.y(), 0.0};
      const Polygon body = transformed(moved, piece);
      if (room_at(to) != room || !is_off_walls(body) || !is_clear(body, *i)) continue;
      done_.after.furniture[*i].outline = body;
      moved_.insert(*i);
      done_.alterations.push_back(
          {ChangeKind::furniture_moved, from, to, {room->id}, {piece, body}});
      return;
    }
  }

  void remove_furniture() {
    const std::optional<std::size_t> i = some_piece();
    if (!i) return;
    const Polygon outline = done_.before.furniture[*i].outline;
    const Point2 at = middle_of(outline.outer);
    const bool is_gone = draw_.happens(0.5);
    (is_gone ? done_.after : done_.before).furniture[*i].outline = {};
    moved_.insert(*i);
    done_.alterations.push_back({is_gone ? ChangeKind::furniture_gone : ChangeKind::furniture_new,
                                 at,
                                 at,
                                 {room_at(at)->id},
                                 {outline}});
  }

  void build_wall() {
    const auto& rooms = done_.before.rooms;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      const PlanRoom& room = draw_.one_of(rooms);
      const Ring& ring = room.parts.front().outer;
      const auto side = static_cast<std::size_t>(draw_.whole(0, static_cast<int>(ring.size()) - 1));
      const Point2 way = ring[(side + 1) % ring.size()] - ring[side];
      const double share = draw_.between(0.1, 0.9);
      const double length_m = draw_.between(1.0, 2.5);
      const double half_m = draw_.between(0.05, 0.1);
      if (way.norm() < 2.0 || room.area_m2 < 12.0) continue;
      const Point2 foot = ring[side] + share * way;
      const Point2 along = way.normalized();
      Point2 inwards(-along.y(), along.x());
      if (!contains(room.parts.front(), foot + 0.05 * inwards)) inwards = -inwards;
      const auto at = [&](double across_m, double along_m) {
        return Point2(foot + across_m * inwards + along_m * along);
      };
      // A wall's end leaves a way around it, and its foot stands in the wall.
      const Polygon free_end{{at(0.2, -half_m), at(length_m + 1.1, -half_m),
                              at(length_m + 1.1, half_m), at(0.2, half_m)},
                             {}};
      const Polygon body{
          {at(-0.03, -half_m), at(length_m, -half_m), at(length_m, half_m), at(-0.03, half_m)}, {}};
      if (!is_off_walls(free_end) || !is_clear(body, {})) continue;
      const bool is_new = draw_.happens(0.6);
      (is_new ? done_.after : done_.before).walls.push_back(body);
      done_.alterations.push_back({is_new ? ChangeKind::wall_new : ChangeKind::wall_gone,
                                   at(length_m / 2.0, 0.0),
                                   at(length_m / 2.0, 0.0),
                                   {room.id},
                                   {body}});
      return;
    }
  }

  Draw& draw_;
  AlteredWorld done_;
  std::set<std::size_t> shut_;
  std::set<std::size_t> moved_;
};

}  // namespace

AlteredWorld altered(const FloorPlan& world, int count, Draw& draw) {
  Alterer alterer(world, draw);
  for (int i = 0; i < count; ++i) alterer.alter_something();
  return alterer.taken();
}

}  // namespace roomatlas::bench
