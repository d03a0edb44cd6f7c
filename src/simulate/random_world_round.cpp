// SPDX-License-Identifier: GPL-3.0-or-later
// Buildings whose walls are not at right angles: wings and rotundas.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "random_world_kinds.hpp"

namespace roomatlas::random_world_draft {
namespace {

constexpr double kBesideCorridorM = 0.3;  // of a hub's wall, on both sides of where a wing begins

/// Where the lines n . p = at cross.
Point2 crossing(const Point2& first_normal, double first_m, const Point2& second_normal,
                double second_m) {
  const double determinant = cross(first_normal, second_normal);
  return {(first_m * second_normal.y() - second_m * first_normal.y()) / determinant,
          (second_m * first_normal.x() - first_m * second_normal.x()) / determinant};
}

/// A polygon of equal sides around the origin. Side k looks along (k + 1/2) steps.
struct Circle {
  int sides = 12;
  double apothem_m = 5.0;

  [[nodiscard]] double step_rad() const { return 2.0 * kPi / sides; }
  [[nodiscard]] Point2 normal(int side) const { return direction((side + 0.5) * step_rad()); }
  [[nodiscard]] Point2 corner(int at, double apothem_of_ring_m) const {
    return apothem_of_ring_m / std::cos(kPi / sides) * direction(at * step_rad());
  }
  [[nodiscard]] double side_m() const { return 2.0 * apothem_m * std::tan(kPi / sides); }
  /// In the middle of a side, theta out of it.
  [[nodiscard]] Pose2 out_of(int side, double apothem_of_ring_m) const {
    const Point2 at = apothem_of_ring_m * normal(side);
    return {at.x(), at.y(), wrap_angle((side + 0.5) * step_rad())};
  }
};

/// The room around some sides of the circle, between two rays from its middle, half a wall off.
Ring sector(const Circle& circle, int first, int count, double depth_m, double wall_m) {
  const double inner_m = circle.apothem_m + wall_m;
  const int last = first + count - 1;
  const double from_rad = first * circle.step_rad();
  const double to_rad = (first + count) * circle.step_rad();
  const Point2 from = direction(from_rad + kPi / 2.0);
  const Point2 to = direction(to_rad + kPi / 2.0);
  Ring ring;
  ring.push_back(crossing(circle.normal(last), inner_m, to, -wall_m / 2.0));
  for (int at = first + count - 1; at > first; --at) ring.push_back(circle.corner(at, inner_m));
  ring.push_back(crossing(circle.normal(first), inner_m, from, wall_m / 2.0));
  ring.push_back(crossing(circle.normal(first), inner_m + depth_m, from, wall_m / 2.0));
  for (int at = first + 1; at < first + count; ++at) {
    ring.push_back(circle.corner(at, inner_m + depth_m));
  }
  ring.push_back(crossing(circle.normal(last), inner_m + depth_m, to, -wall_m / 2.0));
  return ring;
}

/// The largest door in a side of the circle whose ends are half a wall shorter.
double door_in_side_m(const Circle& circle, const Style& style, RandomStream& random) {
  return drawn_door_m(random, style, circle.side_m() - style.wall_m);
}

}  // namespace

Draft wings(RandomStream& random, Style style, int rooms) {
  Draft draft(style.wall_m);
  style.depth_m = std::min(style.depth_m, 5.0);
  const double bend_rad = radians(between(random, 10.0, 80.0));
  const double second_rad = kPi - bend_rad;
  const std::array<double, 3> ways_rad = {0.0, second_rad,
                                          second_rad + (2.0 * kPi - second_rad) / 2.0};
  const int wings = random.uniform() < 0.6 ? 2 : 3;
  const double half_m = style.corridor_m / 2.0 + kBesideCorridorM;
  const double tangent = std::tan(std::min(second_rad, kPi - second_rad / 2.0) / 2.0);
  const double apothem_m = std::max(1.1 * half_m / tangent, between(random, 1.2, 3.0));
  Ring hub;
  for (const double way_rad : ways_rad) {
    for (const double side : {-half_m, half_m}) {
      hub.push_back(apothem_m * direction(way_rad) + side * direction(way_rad + kPi / 2.0));
    }
  }
  const std::size_t middle = draft.add_room({hub, {}}, RoomKind::hall);
  // Rows begin where those of the next wing are out of the way.
  const double reach_m = style.corridor_m / 2.0 + 2.0 * style.wall_m + 6.5;
  const double begin_m = apothem_m + style.wall_m;
  int left = std::max(wings, rooms - 1 - wings);
  for (int i = 0; i < wings; ++i) {
    const int here = i + 1 == wings ? left : left / (wings - i);
    left -= here;
    const double bare_m = std::max(0.0, reach_m / tangent - begin_m);
    const double length_m = bare_m + std::max(3.0, static_cast<double>((here + 1) / 2) *
                                                       (style.mean_width_m() + style.wall_m));
    const double way_rad = ways_rad[static_cast<std::size_t>(i)];
    const Pose2 along{0.0, 0.0, wrap_angle(way_rad)};
    const std::size_t corridor =
        add_strip(draft, random, style,
                  {along * Pose2{begin_m, 0.0, 0.0}, length_m, bare_m, (here + 1) / 2, here / 2});
    draft.add_door(middle, corridor, along * Pose2{apothem_m, 0.0, 0.0},
                   std::min(1.6, style.corridor_m - 0.3));
  }
  return draft;
}

Draft rotunda(RandomStream& random, Style style, int rooms) {
  Draft draft(style.wall_m);
  const Circle circle{whole_between(random, 12, 16), between(random, 4.2, 7.5)};
  Ring outline;
  for (int at = 0; at < circle.sides; ++at) outline.push_back(circle.corner(at, circle.apothem_m));
  const std::size_t hall = draft.add_room({outline, {}}, RoomKind::hall);
  const int sectors = std::clamp(rooms - 1, 2, circle.sides / 2);
  int side = 0;
  std::size_t lobby = 0;
  for (int i = 0; i < sectors; ++i) {
    const int count = (circle.sides - side) / (sectors - i);
    const std::size_t room = draft.add_room(
        {sector(circle, side, count, style.depth_m, style.wall_m), {}}, RoomKind::room);
    draft.add_door(hall, room, circle.out_of(side + count / 2, circle.apothem_m),
                   door_in_side_m(circle, style, random));
    if (i == 0) lobby = room;
    side += count;
  }
  const int left = rooms - 2 - sectors;
  if (left <= 0) return draft;
  const int door_side = circle.sides / sectors / 2;
  const double outer_m = circle.apothem_m + style.wall_m + style.depth_m;
  const double length_m =
      std::max(3.0, (left + 1) / 2 * (style.mean_width_m() + style.wall_m) - style.wall_m);
  const std::size_t corridor = add_strip(
      draft, random, style,
      {circle.out_of(door_side, outer_m + style.wall_m), length_m, 0.0, (left + 1) / 2, left / 2});
  draft.add_door(lobby, corridor, circle.out_of(door_side, outer_m),
                 std::min(1.6, style.corridor_m - 0.3));
  return draft;
}

}  // namespace roomatlas::random_world_draft
