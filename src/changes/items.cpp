// SPDX-License-Identifier: GPL-3.0-or-later
#include "items.hpp"

#include "roomatlas/core/convex_hull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomatlas::changes {
namespace {

constexpr double kChangedShare = 0.3;  // of a drawn piece's edge, from which all of it is altered
constexpr double kStep_m = 0.05;       // along edges
constexpr double kSameWay_deg = 10.0;  // two walls that are parallel
constexpr double kOverlap = 0.5;       // of the shorter of two walls that are one, or one moved
constexpr double kMarginM = 0.025;     // half a cell
constexpr double kDoor_m = 0.1;        // as thick as a shut door is drawn

void add(const Witness& more, Witness& to) {
  const bool is_first = to.visits.empty();
  to.hits += more.hits;
  to.passes += more.passes;
  if (!more.visits.empty()) {
    to.first_s = is_first ? more.first_s : std::min(to.first_s, more.first_s);
    to.last_s = is_first ? more.last_s : std::max(to.last_s, more.last_s);
  }
  to.lasting_s = std::max(to.lasting_s, more.lasting_s);
  std::vector<AsrId> visits;
  std::set_union(to.visits.begin(), to.visits.end(), more.visits.begin(), more.visits.end(),
                 std::back_inserter(visits));
  to.visits = std::move(visits);
}

/// Points along a ring, all of it.
std::vector<Point2> along(const Ring& ring) {
  std::vector<Point2> points;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 side = ring[(i + 1) % ring.size()] - ring[i];
    const int steps = std::max(1, static_cast<int>(std::ceil(side.norm() / kStep_m)));
    for (int k = 0; k < steps; ++k) points.emplace_back(ring[i] + side * k / steps);
  }
  return points;
}

/// The share of a piece's edge that was altered.
double changed_share(const Ring& outline, const std::vector<Point2>& points, double reach_m) {
  const std::vector<Point2> edge = along(outline);
  const auto near = std::count_if(edge.begin(), edge.end(), [&](const Point2& at) {
    return std::any_of(points.begin(), points.end(),
                       [&](const Point2& point) { return (point - at).norm() <= reach_m; });
  });
  return static_cast<double>(near) / static_cast<double>(edge.size());
}

/// The convex outline of some cells: nothing reaches beyond the walls of a convex room.
Ring hull_of(const std::vector<Point2>& middles) {
  std::vector<Point2> corners;
  for (const Point2& at : middles) {
    for (const double x_m : {-kMarginM, kMarginM}) {
      for (const double y_m : {-kMarginM, kMarginM}) corners.emplace_back(at + Point2(x_m, y_m));
    }
  }
  return convex_hull(std::move(corners));
}

/// Its size and outline: the drawn piece where all of it was altered, else what was.
void measure(Item& item, const FloorPlan& plan, const ChangeOptions& options) {
  item.extent = extent_of(item.altered.points, kMarginM);
  item.outline = {hull_of(item.altered.points), {}};
  if (!item.thing.piece) return;
  const Polygon& piece = plan.furniture[*item.thing.piece].outline;
  if (changed_share(piece.outer, item.altered.points, options.wall_reach_m) < kChangedShare) return;
  item.extent = extent_of(piece.outer);
  item.outline = piece;
}

/// A door from jamb to jamb.
Ring filled(const DoorPlace& door) {
  const Point2 along = (door.jambs.b - door.jambs.a) / door.width_m;
  return ring_of({door.middle(), along, door.width_m, kDoor_m});
}

bool same_way(const Extent& a, const Extent& b) {
  return std::abs(cross(a.along, b.along)) <= std::sin(radians(kSameWay_deg));
}

/// How far two walls lie side by side, in metres; negative where they do not.
double side_by_side_m(const Extent& a, const Extent& b) {
  const double off_m = std::abs(a.along.dot(b.middle - a.middle));
  return (a.length_m + b.length_m) / 2.0 - off_m;
}

/// Two faces of one wall.
bool are_faces_of_one(const Item& a, const Item& b, const ChangeOptions& options) {
  if (!same_way(a.extent, b.extent)) return false;
  const double shorter_m = std::min(a.extent.length_m, b.extent.length_m);
  return side_by_side_m(a.extent, b.extent) >= kOverlap * shorter_m &&
         std::abs(cross(a.extent.along, b.extent.middle - a.extent.middle)) <=
             options.longest_across_m;
}

bool are_one(const Item& a, const Item& b, const ChangeOptions& options) {
  if (a.altered.is_new != b.altered.is_new || a.thing.kind != b.thing.kind) return false;
  switch (a.thing.kind) {
    case ThingKind::gap:
    case ThingKind::leaf:
      return a.thing.door == b.thing.door;
    case ThingKind::wall:
      return are_faces_of_one(a, b, options);
    case ThingKind::furniture:
      break;
  }
  return a.thing.piece && a.thing.piece == b.thing.piece;
}

/// How far what stands now is from what stood; nothing where they are not alike.
std::optional<double> moved_m(const Item& gone, const Item& now, const ChangeOptions& options) {
  if (gone.altered.is_new || !now.altered.is_new || gone.thing.kind != now.thing.kind) return {};
  const Extent& from = gone.extent;
  const Extent& to = now.extent;
  const Point2 way = to.middle - from.middle;
  if (gone.thing.kind == ThingKind::wall) {
    const double shorter_m = std::min(from.length_m, to.length_m);
    const double across_m = std::abs(cross(from.along, way));
    const bool is_moved = same_way(from, to) && across_m <= options.wall_moved_m &&
                          side_by_side_m(from, to) >= kOverlap * shorter_m;
    return is_moved ? std::optional(across_m) : std::nullopt;
  }
  if (gone.thing.kind != ThingKind::furniture) return {};
  const bool is_alike = std::abs(from.length_m - to.length_m) <= options.like_size_m &&
                        std::abs(from.width_m - to.width_m) <= options.like_size_m;
  return is_alike && way.norm() <= options.moved_m ? std::optional(way.norm()) : std::nullopt;
}

}  // namespace

void add(const Altered& more, Altered& to) {
  to.points.insert(to.points.end(), more.points.begin(), more.points.end());
  add(more.before, to.before);
  add(more.after, to.after);
}

std::vector<Item> items_of(const std::vector<Altered>& altered, const FloorPlan& before,
                           const FloorPlan& after, const std::vector<DoorPlace>& doors,
                           const ChangeOptions& options) {
  std::vector<Item> items;
  for (const Altered& one : altered) {
    const FloorPlan& plan = one.is_new ? after : before;
    const FloorPlan& other = one.is_new ? before : after;
    Item item{thing_of(one, plan, other, doors, options), one, {}, {}};
    item.extent = extent_of(one.points, kMarginM);
    const auto same = std::find_if(items.begin(), items.end(), [&](const Item& so_far) {
      return are_one(item, so_far, options);
    });
    if (same == items.end()) {
      items.push_back(std::move(item));
    } else {
      add(one, same->altered);
      same->extent = extent_of(same->altered.points, kMarginM);
    }
  }
  for (Item& item : items) {
    measure(item, item.altered.is_new ? after : before, options);
    if (item.thing.kind == ThingKind::gap) item.outline = {filled(doors[item.thing.door]), {}};
  }
  return items;
}

std::vector<MovedPair> moved_pairs(const std::vector<Item>& items, const ChangeOptions& options) {
  struct Candidate {
    double moved_m = 0.0;
    MovedPair pair;
  };
  std::vector<Candidate> candidates;
  for (std::size_t gone = 0; gone < items.size(); ++gone) {
    for (std::size_t now = 0; now < items.size(); ++now) {
      const auto distance_m = moved_m(items[gone], items[now], options);
      if (distance_m) candidates.push_back({*distance_m, {gone, now}});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.moved_m < b.moved_m; });
  std::vector<bool> is_taken(items.size(), false);
  std::vector<MovedPair> pairs;
  for (const auto& [distance_m, pair] : candidates) {
    if (is_taken[pair.gone] || is_taken[pair.appeared]) continue;
    is_taken[pair.gone] = is_taken[pair.appeared] = true;
    pairs.push_back(pair);
  }
  return pairs;
}

}  // namespace roomatlas::changes
