// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/rooms/segment_rooms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "path_places.hpp"

namespace roomatlas {
namespace {

constexpr double kCutBeyondM = 0.2;    // on either side of an opening that cuts the floor
constexpr double kHalfPassageM = 0.3;  // what is seen through narrower gaps is not the room's
constexpr double kOneJambM = 0.5;      // jambs this near are one
constexpr double kBesideFromM = 0.2;   // an opening's own room is looked up this far off its line:
constexpr double kBesideToM = 0.6;     // nearer lies the cut, farther another room
constexpr int kMostRounds = 50;        // each opens or joins something; only to be sure of an end
// Over edges, not corners.
constexpr std::array<Cell, 4> kSides = {Cell{1, 0}, Cell{0, 1}, Cell{-1, 0}, Cell{0, -1}};

/// Free space that is wide enough to be part of a room, or that the robot drove through.
CellMask roomy(const BuildingGrid& grid, const std::vector<Pose2>& path) {
  CellMask on_path(grid.passable.domain);
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
        const std::vector<Doorway>& openings, const SegmentOptions& options)
      : grid_(grid),
        path_(path),
        openings_(openings),
        options_(options),
        roomy_(roomy(grid, path)),
        places_(grid, path, openings, options.see_m),
        is_closed_(openings.size(), true) {
    for (std::size_t i = 0; i < openings.size(); ++i) {
      drives_through_.push_back(places_.drives_through(i));
      if (is_wide(i) && !drives_through_[i].empty()) is_closed_[i] = false;
    }
  }

  RoomSegmentation decided() {
    RoomSegmentation rooms = segmented();
    for (int round = 0; round < kMostRounds && open_false_doors(rooms); ++round) {
      rooms = {};  // its cells are many: gives them back first
      rooms = segmented();
    }
    remove_doubled_doors(rooms);
    return rooms;
  }

 private:
  [[nodiscard]] RoomSegmentation segmented() const {
    RoomSegmentation result;
    result.frame = grid_.frame;
    const std::vector<std::size_t> set_of = places_.sets(is_closed_, joined_);
    std::map<std::size_t, RoomId> number_of;
    for (const std::size_t place : places_.of_poses()) {
      const auto next = static_cast<RoomId>(number_of.size() + 1);
      result.room_of_pose.push_back(number_of.try_emplace(set_of[place], next).first->second);
    }
    result.rooms = static_cast<RoomId>(number_of.size());
    fill(result);
    for (std::size_t i = 0; i < openings_.size(); ++i) {
      if (!is_closed_[i]) continue;
      Door& door = result.openings.emplace_back();
      static_cast<Doorway&>(door) = openings_[i];
      door.room_a = beside(result, openings_[i], -1.0);
      door.room_b = beside(result, openings_[i], 1.0);
      door.is_driven = !drives_through_[i].empty();
    }
    return result;
  }

  /// A doorway is seen twice where its chords differ at one jamb, that of a door leaf: of two
  /// openings between the same rooms whose jambs meet, the one that was not used is none.
  static void remove_doubled_doors(RoomSegmentation& rooms) {
    const auto share_jamb = [](const Segment2& a, const Segment2& b) {
      for (const Point2& p : {a.a, a.b}) {
        for (const Point2& q : {b.a, b.b}) {
          if ((p - q).norm() < kOneJambM) return true;
        }
      }
      return false;
    };
    const std::vector<Door> all = rooms.openings;
    std::erase_if(rooms.openings, [&](const Door& one) {
      return !one.is_driven && one.is_between_rooms() &&
             std::any_of(all.begin(), all.end(), [&](const Door& other) {
               return other.is_driven &&
                      std::minmax(one.room_a, one.room_b) ==
                          std::minmax(other.room_a, other.room_b) &&
                      share_jamb(one.jambs, other.jambs);
             });
    });
  }

  /// Roomy space goes to the room from which it is reached first.
  void fill(RoomSegmentation& result) const {
    result.room_of_cell = Raster<std::int32_t>(grid_.free.domain, 0);
    CellMask open = roomy_;
    for (std::size_t i = 0; i < openings_.size(); ++i) {
      if (is_closed_[i]) cut(open, openings_[i]);
    }
    std::deque<Cell> front;
    const auto take = [&](const Cell& cell, RoomId room) {
      if (!open.at(cell) || result.at(cell) != 0) return;
      result.room_of_cell[cell] = static_cast<std::int32_t>(room);
      front.push_back(cell);
    };
    for (std::size_t i = 0; i < path_.size(); ++i) {
      take(grid_.frame.cell_of(path_[i].position()), result.room_of_pose[i]);
    }
    for (; !front.empty(); front.pop_front()) {
      const Cell at = front.front();
      for (const Cell& side : kSides) {
        take({at.x + side.x, at.y + side.y}, result.at(at));
      }
    }
  }

  void cut(CellMask& open, const Doorway& opening) const {
    const double step_m = grid_.frame.cell_m / 4.0;
    const Point2 along = direction(opening.frame_from_pivot.theta_rad);
    const Point2 left = direction(opening.frame_from_pivot.theta_rad + kPi / 2.0);
    const double half_m = opening.width_m / 2.0 + kCutBeyondM;
    for (double off_m = -half_m; off_m <= half_m; off_m += step_m) {
      for (double band_m = -3.0 * step_m; band_m <= 3.0 * step_m; band_m += step_m) {
        open.set(grid_.frame.cell_of(opening.frame_from_pivot.position() + off_m * left +
                                     band_m * along),
                 false);
      }
    }
  }

  /// The room on one side of an opening, where the robot was in one.
  [[nodiscard]] std::optional<RoomId> beside(const RoomSegmentation& rooms, const Doorway& opening,
                                             double sign) const {
    const Point2 along = sign * direction(opening.frame_from_pivot.theta_rad);
    for (double off_m = kBesideFromM; off_m < kBesideToM; off_m += grid_.frame.cell_m / 2.0) {
      const RoomId room =
          rooms.at(grid_.frame.cell_of(opening.frame_from_pivot.position() + off_m * along));
      if (room != 0) return room;
    }
    return std::nullopt;
  }

  [[nodiscard]] bool is_wide(std::size_t opening) const {
    return openings_[opening].width_m > options_.doors.max_width_m;
  }

  /// The floor of each room, by its number; 0: of none, too large to matter.
  [[nodiscard]] std::vector<double> areas_m2(const RoomSegmentation& rooms) const {
    const double cell_m2 = rooms.frame.cell_m * rooms.frame.cell_m;
    std::vector<double> areas(static_cast<std::size_t>(rooms.rooms) + 1, 0.0);
    for (const auto room : rooms.room_of_cell.values)
      areas[static_cast<std::size_t>(room)] += cell_m2;
    areas[0] = std::numeric_limits<double>::infinity();
    return areas;
  }

  /// The rooms that an opening parts: those beside it, and those that were driven between. A room
  /// may have no floor beside it, or none at all.
  using RoomPair = std::pair<RoomId, RoomId>;
  [[nodiscard]] std::vector<RoomPair> rooms_at(std::size_t opening, const Door& beside,
                                               const std::vector<RoomId>& room_of_place) const {
    std::vector<RoomPair> pairs;
    if (beside.is_between_rooms()) pairs.emplace_back(*beside.room_a, *beside.room_b);
    for (const auto& [from, to] : drives_through_[opening]) {
      const RoomPair pair(room_of_place[from], room_of_place[to]);
      if (pair.first != pair.second) pairs.push_back(pair);
    }
    return pairs;
  }

  /// Joins the smaller of two rooms at an opening with a third, where its floor goes over into that
  /// one's or it has none itself: the robot looked in at a door and turned back, and was in the
  /// room behind by another way.
  bool join_by_floor(const RoomSegmentation& rooms, const Door& opening, const RoomPair& pair,
                     const std::vector<double>& area_m2) {
    const auto area_of = [&](RoomId room) { return area_m2[static_cast<std::size_t>(room)]; };
    const auto [small, other] =
        area_of(pair.first) < area_of(pair.second) ? pair : RoomPair(pair.second, pair.first);
    RoomId third = most_touched_by(small, rooms);
    if (area_of(small) == 0.0) {
      third = (opening.room_a == other ? opening.room_b : opening.room_a).value_or(0);
    }
    if (third == 0 || third == other) return false;
    const auto place_in = [&](RoomId room) {
      const auto pose = std::find(rooms.room_of_pose.begin(), rooms.room_of_pose.end(), room);
      return places_.of_poses()[static_cast<std::size_t>(pose - rooms.room_of_pose.begin())];
    };
    joined_.emplace_back(place_in(small), place_in(third));
    return true;
  }

  /// The room that shares most edges of cells with one that was entered; 0: none does.
  [[nodiscard]] RoomId most_touched_by(RoomId room, const RoomSegmentation& rooms) const {
    std::vector<Cell> seeds;
    for (std::size_t i = 0; i < path_.size(); ++i) {
      const Cell at = grid_.frame.cell_of(path_[i].position());
      if (rooms.room_of_pose[i] == room && rooms.at(at) == room) seeds.push_back(at);
    }
    std::map<RoomId, int> edges;
    std::set<std::int64_t> seen;
    while (!seeds.empty()) {
      const Cell at = seeds.back();
      seeds.pop_back();
      if (!seen.insert(key_of(at)).second) continue;
      for (const Cell& side : kSides) {
        const Cell next{at.x + side.x, at.y + side.y};
        const RoomId there = rooms.at(next);
        if (there == room) seeds.push_back(next);
        if (there != 0 && there != room) ++edges[there];
      }
    }
    const auto most =
        std::max_element(edges.begin(), edges.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == edges.end() ? 0 : most->first;
  }

  /// Opens what is no door after all. False when every closed opening may stay closed.
  bool open_false_doors(const RoomSegmentation& rooms) {
    std::vector<double> area_m2 = areas_m2(rooms);
    const auto of = [&](RoomId room) -> double& { return area_m2[static_cast<std::size_t>(room)]; };
    std::vector<RoomId> room_of_place(places_.of_poses().size(), 0);  // at most one a pose
    for (std::size_t i = 0; i < rooms.room_of_pose.size(); ++i) {
      room_of_place[places_.of_poses()[i]] = rooms.room_of_pose[i];
    }
    bool any = false;
    std::size_t next = 0;  // of the rooms' openings, which are the closed ones in their order
    for (std::size_t i = 0; i < openings_.size(); ++i) {
      if (!is_closed_[i]) continue;
      const Door& opening = rooms.openings[next++];
      const std::vector<RoomPair> pairs = rooms_at(i, opening, room_of_place);
      const auto small = std::find_if(pairs.begin(), pairs.end(), [&](const RoomPair& pair) {
        return std::min(of(pair.first), of(pair.second)) < options_.min_room_m2;
      });
      const bool is_small = small != pairs.end();
      if (opening.room_a != opening.room_b && !is_small &&
          !(is_wide(i) && opening.is_between_rooms())) {
        continue;
      }
      any = true;
      if (!is_small || !join_by_floor(rooms, opening, *small, area_m2)) is_closed_[i] = false;
      if (is_small) of(small->first) = of(small->second) = options_.min_room_m2;  // one a round
    }
    return any;
  }

  const BuildingGrid& grid_;
  const std::vector<Pose2>& path_;
  const std::vector<Doorway>& openings_;
  const SegmentOptions& options_;
  const CellMask roomy_;
  const PathPlaces places_;
  std::vector<bool> is_closed_;
  std::vector<std::pair<std::size_t, std::size_t>> joined_;  ///< places of one room after all
  std::vector<std::vector<std::pair<std::size_t, std::size_t>>> drives_through_;  ///< by opening
};

}  // namespace

std::vector<Doorway> openings_between_rooms(const BuildingGrid& grid,
                                            const SegmentOptions& options) {
  OpeningOptions all = options.doors;
  all.max_width_m = std::max(all.max_width_m, options.max_window_m);
  return find_openings(grid, all);
}

RoomSegmentation segment_rooms(const BuildingGrid& grid, const std::vector<Doorway>& openings,
                               const std::vector<Pose2>& building_from_robot,
                               const SegmentOptions& options) {
  return Rooms(grid, building_from_robot, openings, options).decided();
}

RoomSegmentation segment_rooms(const BuildingGrid& grid,
                               const std::vector<Pose2>& building_from_robot,
                               const SegmentOptions& options) {
  return segment_rooms(grid, openings_between_rooms(grid, options), building_from_robot, options);
}

}  // namespace roomatlas
