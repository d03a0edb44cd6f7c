// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/graph/segment_rooms.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "place_index.hpp"

namespace roomatlas {
namespace {

constexpr double kNodeM = 0.3;          // path nearer than this to an earlier place is that place
constexpr double kFarNodeM = 0.5;       // far sight is tried from one place in each square of this
constexpr double kSpotM = 0.5;          // spots that two places may both see lie on this lattice
constexpr double kSpotSeenM = 3.0;      // and are seen from this near
constexpr double kSightMarginM = 0.25;  // a line of sight has this much free on both sides
constexpr double kSeeThroughM = 4.0;    // through openings, places this near see each other
constexpr double kBeyondJambM = 0.15;   // an opening's line reaches this far into its jambs
constexpr double kCutBeyondM = 0.2;     // the same for cells
constexpr double kHalfPassageM = 0.3;   // what is seen through narrower gaps is not the room's
constexpr int kMostRounds = 50;

/// Sets of numbers that belong together.
class Sets {
 public:
  explicit Sets(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parents_[find(a)] = find(b); }

 private:
  std::vector<std::size_t> parents_;
};

/// Which openings a straight line crosses.
class Crossings {
 public:
  explicit Crossings(const std::vector<Opening>& openings) {
    for (std::size_t i = 0; i < openings.size(); ++i) {
      const Segment2& jambs = openings[i].jambs;
      const Point2 outward = (jambs.a - jambs.b).normalized() * kBeyondJambM;
      lines_.push_back({jambs.a + outward, jambs.b - outward});
      index_.add(i, box_around(openings[i].middle(), openings[i].width_m() / 2.0 + kBeyondJambM));
    }
  }
  [[nodiscard]] std::vector<std::size_t> of(const Point2& from, const Point2& to) const {
    std::vector<std::size_t> crossed;
    Box2 box;
    box.extend(from);
    box.extend(to);
    for (const std::size_t i : index_.near(box)) {
      if (crossing_fraction({from, to}, lines_[i])) crossed.push_back(i);
    }
    return crossed;
  }

 private:
  std::vector<Segment2> lines_;
  PlaceIndex index_;
};

/// Two places that belong together unless one of these openings parts them.
struct Link {
  std::size_t a = 0;
  std::size_t b = 0;
  std::vector<std::size_t> crossed;
};

/// The path as places, and which of them belong together.
class Places {
 public:
  Places(const BuildingGrid& grid, const std::vector<Pose2>& path,
         const std::vector<Opening>& openings, double see_m)
      : grid_(grid), crossings_(openings) {
    take_places(path);
    link_driven(path);
    link_seen(see_m);
  }

  /// A number for the set of each place, while some openings are closed.
  [[nodiscard]] std::vector<std::size_t> sets(const std::vector<bool>& is_closed) const {
    Sets sets(points_.size());
    for (const Link& link : links_) {
      const bool is_parted = std::any_of(link.crossed.begin(), link.crossed.end(),
                                         [&](std::size_t i) { return is_closed[i]; });
      if (!is_parted) sets.join(link.a, link.b);
    }
    std::vector<std::size_t> set_of(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) set_of[i] = sets.find(i);
    return set_of;
  }
  [[nodiscard]] const std::vector<std::size_t>& of_poses() const { return place_of_pose_; }
  [[nodiscard]] bool is_driven_through(std::size_t opening) const {
    return std::any_of(links_.begin(), links_.begin() + driven_links_, [&](const Link& link) {
      return std::find(link.crossed.begin(), link.crossed.end(), opening) != link.crossed.end();
    });
  }

 private:
  /// A pose opens a place unless one that it can be joined to directly lies in the same square.
  void take_places(const std::vector<Pose2>& path) {
    std::map<std::pair<int, int>, std::vector<std::size_t>> in_square;
    for (const Pose2& pose : path) {
      const Point2 at = pose.position();
      auto& near = in_square[{static_cast<int>(std::floor(at.x() / kNodeM)),
                              static_cast<int>(std::floor(at.y() / kNodeM))}];
      const auto same = std::find_if(near.begin(), near.end(), [&](std::size_t place) {
        return crossings_.of(points_[place], at).empty();
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

  void link_driven(const std::vector<Pose2>& path) {
    for (std::size_t i = 1; i < path.size(); ++i) {
      const std::size_t a = place_of_pose_[i - 1];
      const std::size_t b = place_of_pose_[i];
      if (a == b) continue;
      links_.push_back({a, b, crossings_.of(path[i - 1].position(), path[i].position())});
    }
    driven_links_ = static_cast<std::ptrdiff_t>(links_.size());
  }

  /// Links places that see each other: all that are near, and of the others one in a square.
  void link_seen(double see_m) {
    Sets known(points_.size());
    for (const Link& link : links_) {
      if (link.crossed.empty()) known.join(link.a, link.b);
    }
    std::vector<std::size_t> all(points_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    link_seen(all, kSeeThroughM, known);
    std::set<std::pair<int, int>> squares;
    std::vector<std::size_t> sparse;
    for (const std::size_t i : all) {
      const auto square = std::pair{static_cast<int>(std::floor(points_[i].x() / kFarNodeM)),
                                    static_cast<int>(std::floor(points_[i].y() / kFarNodeM))};
      if (squares.insert(square).second) sparse.push_back(i);
    }
    link_seen(sparse, see_m, known);
    link_by_common_sight(all, known);
  }

  /// Links places that see one and the same spot of roomy space: two ways past a pillar.
  void link_by_common_sight(const std::vector<std::size_t>& places, Sets& known) {
    PlaceIndex index;
    for (const std::size_t i : places) index.add(i, box_around(points_[i], 0.0));
    const int stride = std::max(1, static_cast<int>(std::lround(kSpotM / grid_.frame.cell_m)));
    for_each_cell(grid_.passable.box, [&](const Cell& cell) {
      if (cell.x % stride != 0 || cell.y % stride != 0 || !grid_.passable.at(cell)) return;
      const Point2 spot = grid_.frame.center_of(cell);
      std::optional<std::size_t> first;
      for (const std::size_t i : index.near(box_around(spot, kSpotSeenM))) {
        if ((points_[i] - spot).norm() > kSpotSeenM) continue;
        if (first && known.find(*first) == known.find(i)) continue;
        if (!crossings_.of(points_[i], spot).empty() || !can_see(points_[i], spot)) continue;
        if (first) {
          links_.push_back({*first, i, {}});
          known.join(*first, i);
        }
        first = i;
      }
    });
  }

  /// @param known places that belong together even with every opening closed: they need no link
  void link_seen(const std::vector<std::size_t>& among, double see_m, Sets& known) {
    PlaceIndex index;
    for (const std::size_t i : among) {
      for (const std::size_t j : index.near(box_around(points_[i], see_m))) {
        const double apart_m = (points_[i] - points_[j]).norm();
        if (apart_m > see_m || known.find(i) == known.find(j)) continue;
        Link link{i, j, crossings_.of(points_[i], points_[j])};
        const bool is_parted = !link.crossed.empty();
        if ((is_parted && apart_m > kSeeThroughM) || !can_see(points_[i], points_[j])) continue;
        if (!is_parted) known.join(i, j);
        links_.push_back(std::move(link));
      }
      index.add(i, box_around(points_[i], 0.0));
    }
  }

  [[nodiscard]] bool can_see(const Point2& from, const Point2& to) const {
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

  const BuildingGrid& grid_;
  const Crossings crossings_;
  std::vector<Point2> points_;
  std::vector<std::size_t> place_of_pose_;
  std::vector<Link> links_;
  std::ptrdiff_t driven_links_ = 0;  ///< of `links_`, the first so many
};

/// Free space that is wide enough to be part of a room, or that the robot drove through.
CellMask roomy(const BuildingGrid& grid, const std::vector<Pose2>& path) {
  CellMask on_path(grid.passable.box);
  std::vector<Cell> seeds;
  for (const Pose2& pose : path) {
    seeds.push_back(grid.frame.cell_of(pose.position()));
    on_path.set(seeds.back(), true);
  }
  const int half = static_cast<int>(std::lround(kHalfPassageM / grid.frame.cell_m));
  const CellMask wide = dilated(eroded(grid.passable, half), half);
  return connected_to(both(either(wide, dilated(on_path, half)), grid.passable), seeds);
}

/// The rooms while some openings are closed.
class Rooms {
 public:
  Rooms(const BuildingGrid& grid, const std::vector<Pose2>& path,
        const std::vector<Opening>& openings, const SegmentOptions& options)
      : grid_(grid),
        path_(path),
        openings_(openings),
        options_(options),
        roomy_(roomy(grid, path)),
        places_(grid, path, openings, options.see_m),
        is_closed_(openings.size(), true) {
    for (std::size_t i = 0; i < openings.size(); ++i) {
      if (openings[i].width_m() > options.doors.max_width_m && places_.is_driven_through(i)) {
        is_closed_[i] = false;
      }
    }
  }

  RoomSegmentation decided() {
    RoomSegmentation rooms = segmented();
    for (int round = 0; round < kMostRounds && open_false_doors(rooms); ++round) {
      rooms = {};  // its cells are many: gives them back first
      rooms = segmented();
    }
    return rooms;
  }

 private:
  [[nodiscard]] RoomSegmentation segmented() const {
    RoomSegmentation result;
    result.frame = grid_.frame;
    result.box = grid_.free.box;
    const std::vector<std::size_t> set_of = places_.sets(is_closed_);
    std::map<std::size_t, RoomId> number_of;
    for (const std::size_t place : places_.of_poses()) {
      const auto next = static_cast<RoomId>(number_of.size() + 1);
      result.room_of_pose.push_back(number_of.try_emplace(set_of[place], next).first->second);
    }
    result.rooms = static_cast<RoomId>(number_of.size());
    fill(result);
    for (std::size_t i = 0; i < openings_.size(); ++i) {
      if (!is_closed_[i]) continue;
      result.openings.push_back(
          {openings_[i], beside(result, openings_[i], -1.0), beside(result, openings_[i], 1.0)});
    }
    return result;
  }

  /// Roomy space goes to the room from which it is reached first.
  void fill(RoomSegmentation& result) const {
    result.room_of_cell.assign(result.box.count(), 0);
    CellMask open = roomy_;
    for (std::size_t i = 0; i < openings_.size(); ++i) {
      if (is_closed_[i]) cut(open, openings_[i]);
    }
    std::deque<Cell> front;
    const auto take = [&](const Cell& cell, RoomId room) {
      if (!open.at(cell) || result.at(cell) != 0) return;
      result.room_of_cell[result.box.index_of(cell)] = static_cast<std::int32_t>(room);
      front.push_back(cell);
    };
    for (std::size_t i = 0; i < path_.size(); ++i) {
      take(grid_.frame.cell_of(path_[i].position()), result.room_of_pose[i]);
    }
    for (; !front.empty(); front.pop_front()) {
      const Cell at = front.front();
      for (const Cell& side : {Cell{1, 0}, Cell{0, 1}, Cell{-1, 0}, Cell{0, -1}}) {
        take({at.x + side.x, at.y + side.y}, result.at(at));
      }
    }
  }

  void cut(CellMask& open, const Opening& opening) const {
    const double step_m = grid_.frame.cell_m / 4.0;
    const Point2 along = direction(opening.heading_rad);
    const Point2 left = direction(opening.heading_rad + kPi / 2.0);
    const double half_m = opening.width_m() / 2.0 + kCutBeyondM;
    for (double off_m = -half_m; off_m <= half_m; off_m += step_m) {
      for (double band_m = -3.0 * step_m; band_m <= 3.0 * step_m; band_m += step_m) {
        open.set(grid_.frame.cell_of(opening.middle() + off_m * left + band_m * along), false);
      }
    }
  }

  /// The room on one side of an opening.
  [[nodiscard]] RoomId beside(const RoomSegmentation& rooms, const Opening& opening,
                              double sign) const {
    const Point2 along = sign * direction(opening.heading_rad);
    for (double off_m = 0.2; off_m < 0.6; off_m += grid_.frame.cell_m / 2.0) {
      const RoomId room = rooms.at(grid_.frame.cell_of(opening.middle() + off_m * along));
      if (room != 0) return room;
    }
    return 0;
  }

  /// Opens what is no door after all. False when every closed opening may stay closed.
  bool open_false_doors(const RoomSegmentation& rooms) {
    std::vector<double> area_m2(static_cast<std::size_t>(rooms.rooms) + 1, 0.0);
    for (const RoomId room : rooms.room_of_cell) {
      area_m2[static_cast<std::size_t>(room)] += rooms.frame.cell_m * rooms.frame.cell_m;
    }
    area_m2[0] = 0.0;
    bool any = false;
    std::size_t next = 0;  // of the rooms' openings, which are the closed ones in their order
    for (std::size_t i = 0; i < openings_.size(); ++i) {
      if (!is_closed_[i]) continue;
      const RoomOpening& opening = rooms.openings[next++];
      const auto of = [&](RoomId room) -> double& {
        return area_m2[static_cast<std::size_t>(room)];
      };
      const double smaller_m2 = std::min(of(opening.behind), of(opening.ahead));
      const bool is_wide = openings_[i].width_m() > options_.doors.max_width_m;
      const bool is_small = opening.is_door() && smaller_m2 < options_.min_room_m2;
      if (opening.behind != opening.ahead && !is_small && !(is_wide && opening.is_door())) continue;
      is_closed_[i] = false;
      any = true;
      if (is_small) of(opening.behind) = of(opening.ahead) = options_.min_room_m2;  // one a round
    }
    return any;
  }

  const BuildingGrid& grid_;
  const std::vector<Pose2>& path_;
  const std::vector<Opening>& openings_;
  const SegmentOptions& options_;
  const CellMask roomy_;
  const Places places_;
  std::vector<bool> is_closed_;
};

}  // namespace

RoomSegmentation segment_rooms(const BuildingGrid& grid,
                               const std::vector<Pose2>& building_from_robot,
                               const SegmentOptions& options) {
  OpeningOptions all = options.doors;
  all.max_width_m = std::max(all.max_width_m, options.max_window_m);
  const std::vector<Opening> openings = find_openings(grid, all);
  return Rooms(grid, building_from_robot, openings, options).decided();
}

}  // namespace roomatlas
