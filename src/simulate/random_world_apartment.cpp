// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "random_world_kinds.hpp"

namespace roomatlas::random_world_draft {
namespace {

constexpr double kLeastSideM = 2.4;     // of a room
constexpr double kLeastSharedM = 0.95;  // of a wall that two rooms share, for a door in it
constexpr double kLoopShare = 0.15;     // of walls that are not needed, with a door
constexpr double kDoorMarginM = 0.1;    // from a corner

/// Cuts the largest box that is large enough in two, if there is one.
bool split_one(std::vector<Box2>& boxes, RandomStream& random, double wall_m) {
  const auto longer_side_m = [](const Box2& box) { return box.size().maxCoeff(); };
  const auto box = std::max_element(boxes.begin(), boxes.end(), [&](const Box2& a, const Box2& b) {
    return a.size().prod() < b.size().prod();
  });
  const double spare_m = longer_side_m(*box) - wall_m - 2.0 * kLeastSideM;
  if (spare_m <= 0.0) return false;
  const int axis = box->size().x() >= box->size().y() ? 0 : 1;
  const double first_m = kLeastSideM + spare_m * between(random, 0.2, 0.8);
  Box2 second = *box;
  box->max[axis] = box->min[axis] + first_m;
  second.min[axis] = box->max[axis] + wall_m;
  boxes.push_back(second);
  return true;
}

/// A wall between two rooms.
struct Shared {
  std::size_t from = 0;
  std::size_t to = 0;
  int axis = 0;  ///< across the wall
  double face = 0.0;
  double low = 0.0;  ///< along the wall
  double high = 0.0;
};

std::vector<Shared> shared_walls(const std::vector<Box2>& boxes, double wall_m) {
  std::vector<Shared> walls;
  for (std::size_t from = 0; from < boxes.size(); ++from) {
    for (std::size_t to = 0; to < boxes.size(); ++to) {
      for (const int axis : {0, 1}) {
        const int other = 1 - axis;
        const Shared wall{from,
                          to,
                          axis,
                          boxes[from].max[axis],
                          std::max(boxes[from].min[other], boxes[to].min[other]),
                          std::min(boxes[from].max[other], boxes[to].max[other])};
        const double gap_m = boxes[to].min[axis] - wall.face;
        if (std::abs(gap_m - wall_m) < 1e-6 && wall.high - wall.low >= kLeastSharedM) {
          walls.push_back(wall);
        }
      }
    }
  }
  return walls;
}

void add_door_in(Draft& draft, RandomStream& random, const Style& style, const Shared& wall) {
  const double length_m = wall.high - wall.low;
  const double width_m =
      std::min(drawn_door_m(random, style, length_m), length_m - 2.0 * kDoorMarginM);
  const double spare_m = length_m - width_m - 2.0 * kDoorMarginM;
  const double at = wall.low + kDoorMarginM + width_m / 2.0 + spare_m * random.uniform();
  const Pose2 out = wall.axis == 0 ? Pose2{wall.face, at, 0.0} : Pose2{at, wall.face, kPi / 2.0};
  draft.add_door(wall.from, wall.to, out, width_m);
}

}  // namespace

Draft apartment(RandomStream& random, Style style, int rooms) {
  Draft draft(style.wall_m);
  const double area_m2 = rooms * between(random, 11.0, 22.0);
  const double wide_m = std::sqrt(area_m2 * between(random, 1.0, 2.2));
  std::vector<Box2> boxes = {{{0.0, 0.0}, {wide_m, area_m2 / wide_m}}};
  while (std::ssize(boxes) < rooms && split_one(boxes, random, style.wall_m)) {
  }
  for (const Box2& box : boxes) {
    draft.add_room({rectangle(box.min.x(), box.min.y(), box.max.x(), box.max.y()), {}},
                   RoomKind::room);
  }
  std::vector<Shared> walls = shared_walls(boxes, style.wall_m);
  for (std::size_t i = walls.size(); i > 1; --i) {
    std::swap(walls[i - 1],
              walls[static_cast<std::size_t>(whole_between(random, 0, static_cast<int>(i) - 1))]);
  }
  std::vector<std::size_t> group(boxes.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  for (const Shared& wall : walls) {
    const bool is_loop = group[wall.from] == group[wall.to];
    if (is_loop && random.uniform() >= kLoopShare) continue;
    add_door_in(draft, random, style, wall);
    const std::size_t gone = group[wall.to];
    std::replace(group.begin(), group.end(), gone, std::size_t{group[wall.from]});
  }
  return draft;
}

}  // namespace roomatlas::random_world_draft
