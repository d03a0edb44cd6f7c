// SPDX-License-Identifier: GPL-3.0-or-later
#include "path_places.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>

namespace roomatlas {
namespace {

constexpr double kNodeM = 0.3;          // path nearer than this to an earlier place is that place
constexpr double kFarNodeM = 0.5;       // far sight is tried from one place in each square of this
constexpr double kSpotM = 0.5;          // spots that two places may both see lie on this lattice
constexpr double kSpotSeenM = 3.0;      // and are seen from this near
constexpr double kSightMarginM = 0.25;  // a line of sight has this much free on both sides
constexpr double kSeeThroughM = 4.0;    // through openings, places this near see each other
constexpr double kBeyondJambM = 0.15;   // an opening's line reaches this far into its jambs

/// The square that a point lies in.
std::pair<int, int> square_of(const Point2& point, double side_m) {
  return {static_cast<int>(std::floor(point.x() / side_m)),
          static_cast<int>(std::floor(point.y() / side_m))};
}

}  // namespace

OpeningsCrossed::OpeningsCrossed(const std::vector<Doorway>& openings) {
  for (std::size_t i = 0; i < openings.size(); ++i) {
    const Segment2& jambs = openings[i].jambs;
    const Point2 outward = (jambs.a - jambs.b).normalized() * kBeyondJambM;
    lines_.push_back({jambs.a + outward, jambs.b - outward});
    index_.add(i, box_around(openings[i].frame_from_pivot.position(),
                             openings[i].width_m / 2.0 + kBeyondJambM));
  }
}

std::vector<std::size_t> OpeningsCrossed::between(const Point2& from, const Point2& to) const {
  std::vector<std::size_t> crossed;
  Box2 box;
  box.extend(from);
  box.extend(to);
  for (const std::size_t i : index_.near(box)) {
    if (crossing_fraction({from, to}, lines_[i])) crossed.push_back(i);
  }
  return crossed;
}

PathPlaces::PathPlaces(const BuildingGrid& grid, const std::vector<Pose2>& path,
                       const std::vector<Doorway>& openings, double see_m)
    : grid_(grid), openings_(openings) {
  take_places(path);
  link_driven(path);
  link_seen(see_m);
}

std::vector<std::size_t> PathPlaces::sets(
    const std::vector<bool>& is_closed,
    const std::vector<std::pair<std::size_t, std::size_t>>& joined) const {
  Sets sets(points_.size());
  for (const auto& [a, b] : joined) sets.union_set(a, b);
  for (const Link& link : links_) {
    const bool is_parted = std::any_of(link.crossed.begin(), link.crossed.end(),
                                       [&](std::size_t i) { return is_closed[i]; });
    if (!is_parted) sets.union_set(link.a, link.b);
  }
  std::vector<std::size_t> set_of(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) set_of[i] = sets.find_set(i);
  return set_of;
}

std::vector<std::pair<std::size_t, std::size_t>> PathPlaces::drives_through(
    std::size_t opening) const {
  std::vector<std::pair<std::size_t, std::size_t>> drives;
  for (auto link = links_.begin(); link != links_.begin() + driven_links_; ++link) {
    const auto& crossed = link->crossed;
    if (std::find(crossed.begin(), crossed.end(), opening) != crossed.end()) {
      drives.emplace_back(link->a, link->b);
    }
  }
  return drives;
}

/// A pose opens a place unless one that it can be joined to directly lies in the same square.
void PathPlaces::take_places(const std::vector<Pose2>& path) {
  std::map<std::pair<int, int>, std::vector<std::size_t>> in_square;
  for (const Pose2& pose : path) {
    const Point2 at = pose.position();
    auto& near = in_square[square_of(at, kNodeM)];
    const auto same = std::find_if(near.begin(), near.end(), [&](std::size_t place) {
      return openings_.between(points_[place], at).empty();
    });
    if (same == near.end()) {
      near.push_back(points_.size());
      place_of_pose_.push_back(points_.size());
      points_.push_back(at);
    } else {
      place_of_pose_.push_back(*same);
    }
  }
}

void PathPlaces::link_driven(const std::vector<Pose2>& path) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    const std::size_t a = place_of_pose_[i - 1];
    const std::size_t b = place_of_pose_[i];
    if (a == b) continue;
    links_.push_back({a, b, openings_.between(path[i - 1].position(), path[i].position())});
  }
  driven_links_ = static_cast<std::ptrdiff_t>(links_.size());
}

/// Links places that see each other: all that are near, and of the others one in a square.
void PathPlaces::link_seen(double see_m) {
  Sets known(points_.size());
  for (const Link& link : links_) {
    if (link.crossed.empty()) known.union_set(link.a, link.b);
  }
  std::vector<std::size_t> all(points_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  link_seen(all, kSeeThroughM, known);
  std::set<std::pair<int, int>> squares;
  std::vector<std::size_t> sparse;
  for (const std::size_t i : all) {
    if (squares.insert(square_of(points_[i], kFarNodeM)).second) sparse.push_back(i);
  }
  link_seen(sparse, see_m, known);
  link_by_common_sight(all, known);
}

/// Links places that see one and the same spot of roomy space: two ways past a pillar.
void PathPlaces::link_by_common_sight(const std::vector<std::size_t>& places, Sets& known) {
  PlaceIndex index;
  for (const std::size_t i : places) index.add(i, box_around(points_[i], 0.0));
  const int stride = std::max(1, static_cast<int>(std::lround(kSpotM / grid_.frame.cell_m)));
  for_each_cell(grid_.passable.domain, [&](const Cell& cell) {
    if (cell.x % stride != 0 || cell.y % stride != 0 || !grid_.passable.at(cell)) return;
    const Point2 spot = grid_.frame.center_of(cell);
    std::optional<std::size_t> first;
    for (const std::size_t i : index.near(box_around(spot, kSpotSeenM))) {
      if ((points_[i] - spot).norm() > kSpotSeenM) continue;
      if (first && known.find_set(*first) == known.find_set(i)) continue;
      if (!openings_.between(points_[i], spot).empty() || !can_see(points_[i], spot)) continue;
      if (first) {
        links_.push_back({*first, i, {}});
        known.union_set(*first, i);
      }
      first = i;
    }
  });
}

/// @param known places that belong together even with every opening closed: they need no link
void PathPlaces::link_seen(const std::vector<std::size_t>& among, double see_m, Sets& known) {
  PlaceIndex index;
  for (const std::size_t i : among) {
    for (const std::size_t j : index.near(box_around(points_[i], see_m))) {
      const double apart_m = (points_[i] - points_[j]).norm();
      if (apart_m > see_m || known.find_set(i) == known.find_set(j)) continue;
      Link link{i, j, openings_.between(points_[i], points_[j])};
      const bool is_parted = !link.crossed.empty();
      if ((is_parted && apart_m > kSeeThroughM) || !can_see(points_[i], points_[j])) continue;
      if (!is_parted) known.union_set(i, j);
      links_.push_back(std::move(link));
    }
    index.add(i, box_around(points_[i], 0.0));
  }
}

bool PathPlaces::can_see(const Point2& from, const Point2& to) const {
  const double length_m = (to - from).norm();
  const Point2 along = length_m > 0.0 ? Point2((to - from) / length_m) : Point2(1.0, 0.0);
  const Point2 left(-along.y(), along.x());
  for (double at_m = 0.0; at_m <= length_m; at_m += grid_.frame.cell_m / 2.0) {
    for (const double off_m :
         {0.0, kSightMarginM, -kSightMarginM, kSightMarginM / 2.0, -kSightMarginM / 2.0}) {
      if (!grid_.free.at(grid_.frame.cell_of(from + at_m * along + off_m * left))) return false;
    }
  }
  return true;
}

}  // namespace roomatlas
