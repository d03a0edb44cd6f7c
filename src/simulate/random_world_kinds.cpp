// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_world_kinds.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace roomatlas::random_world_draft {
namespace {

constexpr double kBesidePartitionM = 1.3;  // a way past it, for people too
constexpr int kPartitionTries = 40;
constexpr double kPassageM = 1.2;  // width of doors between corridors, at most

/// Length of a row of so many rooms of mean width.
double row_length_m(const Style& style, int count) {
  return std::max(1, count) * (style.mean_width_m() + style.wall_m) - style.wall_m;
}

double passage_m(const Style& style) { return std::min(style.corridor_m - 0.4, kPassageM); }

bool are_apart(const Box2& a, const Box2& b, double gap_m) {
  return (a.min.array() >= b.max.array() + gap_m).any() ||
         (b.min.array() >= a.max.array() + gap_m).any();
}

/// Partitions and columns that leave ways between each other and along the walls of the box.
void add_partitions(Draft& draft, RandomStream& random, const Point2& size, int wanted) {
  std::vector<Box2> bodies;
  for (int attempt = 0; attempt < kPartitionTries && std::ssize(bodies) < wanted; ++attempt) {
    const bool is_column = random.uniform() < 0.3;
    Point2 half(between(random, 0.75, 2.5), between(random, 0.04, 0.1));
    if (is_column) half = Point2::Constant(between(random, 0.15, 0.3));
    if (random.uniform() < 0.5) std::swap(half.x(), half.y());
    const Point2 low = half + Point2::Constant(kBesidePartitionM);
    const Point2 high = size - low;
    const Point2 drawn(random.uniform(), random.uniform());
    if ((high.array() <= low.array()).any()) continue;
    const Point2 middle = low + drawn.cwiseProduct(high - low);
    const Box2 box{middle - half, middle + half};
    const bool has_place = std::all_of(bodies.begin(), bodies.end(), [&](const Box2& other) {
      return are_apart(box, other, kBesidePartitionM);
    });
    if (!has_place) continue;
    bodies.push_back(box);
    draft.add_partition(rectangle(box.min.x(), box.min.y(), box.max.x(), box.max.y()));
  }
}

/// One side of a rectangle from the origin to `size`, 0 the lower, counter-clockwise, as a row
/// outside of it.
Row outside_of(const Point2& size, int side, double depth_m, std::size_t host) {
  const double turns_rad = wrap_angle((side + 2) * kPi / 2.0);
  const Point2 corners[] = {{size.x(), 0.0}, {size.x(), size.y()}, {0.0, size.y()}, {0.0, 0.0}};
  const Point2& corner = corners[side];
  // Seen from outside the side runs clockwise, so that the row lies to its left.
  return {{corner.x(), corner.y(), turns_rad}, side % 2 == 0 ? size.x() : size.y(), depth_m, host};
}

/// A rectangle with rows on its sides, as many as hold the rooms.
void add_rows_around(Draft& draft, RandomStream& random, const Style& style, const Point2& size,
                     std::size_t host, int rooms) {
  const int first = whole_between(random, 0, 3);
  for (int i = 0; i < 4 && rooms > 0; ++i) {
    // Opposite sides first: a hall with rooms on both sides is the usual one.
    const int side = (first + (i == 1 ? 2 : i == 2 ? 1 : i)) % 4;
    const Row row = outside_of(size, side, between(random, 2.8, style.depth_m + 1.0), host);
    const int count = std::min(rooms, rooms_in(row.length_m, style));
    add_row(draft, random, style, row, count);
    rooms -= count;
  }
}

}  // namespace

Draft offices(RandomStream& random, Style style, int rooms) {
  constexpr int kMostAtOne = 20;  // corridor; more make it long for a short robot's day
  Draft draft(style.wall_m);
  double from_x = 0.0;
  std::optional<std::size_t> before;
  for (int left = rooms; left > 0; left -= kMostAtOne) {
    const int here = std::max(1, std::min(left, kMostAtOne) - 1);
    const bool one_sided = !style.equal && random.uniform() < 0.15;
    const int northern = one_sided ? here : (here + 1) / 2;
    const double length_m = row_length_m(style, northern) + between(random, 0.0, 1.5);
    const std::size_t corridor = add_strip(
        draft, random, style, {{from_x, 0.0, 0.0}, length_m, 0.0, northern, here - northern});
    if (before) {
      draft.add_door(*before, corridor, {from_x - style.wall_m, 0.0, 0.0}, passage_m(style));
    }
    before = corridor;
    from_x += length_m + style.wall_m;
  }
  return draft;
}

Draft long_corridor(RandomStream& random, Style style, int rooms) {
  Draft draft(style.wall_m);
  style.least_width_m = 3.0;
  style.most_width_m = std::max(4.0, style.most_width_m);
  const int corridors = whole_between(random, 1, 3);
  const double half_m = style.corridor_m / 2.0;
  int left = std::max(1, rooms - corridors);
  Pose2 start;
  std::optional<std::size_t> before;
  Pose2 door;
  for (int i = 0; i < corridors; ++i) {
    const int here = i + 1 == corridors ? left : left / (corridors - i);
    left -= here;
    // Rooms leave bare wall between the bend and their row.
    const double bare_m = between(random, 4.0, 25.0);
    const double length_m = bare_m + row_length_m(style, here);
    const std::size_t corridor =
        add_strip(draft, random, style, {start, length_m, bare_m, 0, here});
    if (before) draft.add_door(*before, corridor, door, passage_m(style));
    before = corridor;
    door = start * Pose2{length_m - half_m, half_m, kPi / 2.0};
    start = door * Pose2{style.wall_m, 0.0, 0.0};
  }
  return draft;
}

Draft ring(RandomStream& random, Style style, int rooms) {
  Draft draft(style.wall_m);
  const double wide_m = style.corridor_m;
  const Point2 core(between(random, 6.0, 18.0), between(random, 5.0, 11.0));
  const Point2 size = core + Point2::Constant(2.0 * wide_m);
  const Ring hole = rectangle(wide_m, wide_m, wide_m + core.x(), wide_m + core.y());
  const std::size_t corridor =
      draft.add_room({rectangle(0.0, 0.0, size.x(), size.y()), {hole}}, RoomKind::corridor);
  int left = std::max(1, rooms - 1);
  const bool has_core = random.uniform() < 0.7;
  const double depth_m = (core.y() - 3.0 * style.wall_m) / 2.0;
  const double length_m = core.x() - 2.0 * style.wall_m;
  if (has_core && depth_m >= 2.2) {
    const int count = std::min((left + 1) / 2, rooms_in(length_m, style));
    const Pose2 upwards{wide_m + style.wall_m, wide_m, 0.0};
    add_row(draft, random, style, {upwards, length_m, depth_m, corridor}, count);
    left -= count;
    if (left > 0) {
      const Pose2 downwards{wide_m + core.x() - style.wall_m, wide_m + core.y(), wrap_angle(kPi)};
      const int other = std::min(left, count);
      add_row(draft, random, style, {downwards, length_m, depth_m, corridor}, other);
      left -= other;
    }
  }
  add_rows_around(draft, random, style, size, corridor, left);
  return draft;
}

Draft hall(RandomStream& random, Style style, int rooms) {
  Draft draft(style.wall_m);
  const Point2 size(between(random, 8.0, 20.0), between(random, 6.0, 14.0));
  const std::size_t room =
      draft.add_room({rectangle(0.0, 0.0, size.x(), size.y()), {}}, RoomKind::hall);
  add_rows_around(draft, random, style, size, room, std::max(2, rooms - 1));
  return draft;
}

Draft open_plan(RandomStream& random, Style style, int rooms) {
  constexpr int kMostBeside = 6;
  Draft draft(style.wall_m);
  const Point2 size(between(random, 12.0, 24.0), between(random, 9.0, 17.0));
  const std::size_t room =
      draft.add_room({rectangle(0.0, 0.0, size.x(), size.y()), {}}, RoomKind::hall);
  add_partitions(draft, random, size, whole_between(random, 3, 9));
  add_rows_around(draft, random, style, size, room, std::clamp(rooms - 1, 2, kMostBeside));
  return draft;
}

}  // namespace roomatlas::random_world_draft
