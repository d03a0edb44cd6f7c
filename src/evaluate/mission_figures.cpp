// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/mission_figures.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "room_raster.hpp"
#include "roomatlas/core/place_index.hpp"

namespace roomatlas {
namespace {

constexpr double kCellM = 0.2;         ///< of the lattice on which floor is counted
constexpr double kWallStepM = 0.1;     ///< between samples along walls
constexpr double kWallReachM = 0.3;    ///< walls farther away are others
constexpr double kWallCosine = 0.966;  ///< 15 degrees: walls that differ more are others

/// A wall edge that a line fit supports, in the building.
struct PlacedWall {
  Segment2 edge;
  std::size_t mission = 0;
  RoomId room = 0;
};

double root_mean(double squares, double count) {
  return count > 0.0 ? std::sqrt(squares / count) : std::numeric_limits<double>::quiet_NaN();
}

std::vector<PlacedWall> walls_of(const Asr& asr, const Pose2& pose, std::size_t mission,
                                 RoomId room) {
  std::vector<PlacedWall> walls;
  for (const WallPolyline& wall : asr.walls) {
    for (std::size_t i = 1; i < wall.vertices_asr.size(); ++i) {
      if (i > wall.edge_is_fitted.size() || !wall.edge_is_fitted[i - 1]) continue;
      const Segment2 edge{wall.vertices_asr[i - 1], wall.vertices_asr[i]};
      walls.push_back({transformed(pose, edge), mission, room});
    }
  }
  return walls;
}

/// Takes the visits of a mission, in their order.
class Observer {
 public:
  Observer(const FloorPlan& plan, const RoomRaster& raster) : raster_(raster) {
    for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
      for (const AsrId id : plan.rooms[i].asrs) room_of_[id] = i;
      rooms_.push_back({plan.rooms[i].id, 0, 0.0, 0.0, 0.0,
                        static_cast<double>(raster.points()[i].size()) * kCellM * kCellM});
    }
  }

  void take(const Asr& asr, const Pose2& pose) {
    note_visit(asr);
    for (const LatticeCell& cell : cells_in(transformed(pose, asr.outline_asr), kCellM)) {
      const Point2 at((static_cast<double>(cell.column) + 0.5) * kCellM,
                      (static_cast<double>(cell.row) + 0.5) * kCellM);
      const int room = raster_.room_at(at);
      if (room < 0 || !seen_.insert(cell).second) continue;
      rooms_[static_cast<std::size_t>(room)].seen_m2 += kCellM * kCellM;
    }
  }

  void put_into(MissionFigures& mission) const {
    for (const RoomOfMission& room : rooms_) {
      mission.seen_m2 += room.seen_m2;
      if (room.visits > 0 || room.seen_m2 > 0.0) mission.rooms.push_back(room);
    }
    std::sort(mission.rooms.begin(), mission.rooms.end(),
              [](const RoomOfMission& a, const RoomOfMission& b) { return a.room < b.room; });
  }

 private:
  /// Pieces of one room that were driven in turn are one visit.
  void note_visit(const Asr& asr) {
    const auto found = room_of_.find(asr.id);
    if (found == room_of_.end()) return;
    RoomOfMission& room = rooms_[found->second];
    if (room.visits == 0) room.first_s = asr.start_s;
    if (last_ != found->second) ++room.visits;
    room.first_s = std::min(room.first_s, asr.start_s);
    room.last_s =
        room.visits == 1 && last_ != found->second ? asr.end_s : std::max(room.last_s, asr.end_s);
    last_ = found->second;
  }

  const RoomRaster& raster_;
  std::map<AsrId, std::size_t> room_of_;
  std::vector<RoomOfMission> rooms_;  ///< parallel to the plan's
  std::set<LatticeCell> seen_;
  std::optional<std::size_t> last_;
};

/// How far each mission's walls lie from the others'.
void compare_walls(const std::vector<PlacedWall>& walls, std::vector<MissionFigures>& missions) {
  PlaceIndex index;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    Box2 box;
    box.extend(walls[i].edge.a);
    box.extend(walls[i].edge.b);
    index.add(i, box);
  }
  std::vector<double> squares(missions.size(), 0.0);
  std::vector<double> samples(missions.size(), 0.0);
  for (const PlacedWall& wall : walls) {
    const Point2 along = wall.edge.b - wall.edge.a;
    const double length_m = along.norm();
    for (double at_m = kWallStepM / 2.0; at_m < length_m; at_m += kWallStepM) {
      const Point2 at = wall.edge.a + along * (at_m / length_m);
      double nearest_m = kWallReachM;
      for (const std::size_t i : index.near(box_around(at, kWallReachM))) {
        const PlacedWall& other = walls[i];
        const Point2 way = other.edge.b - other.edge.a;
        const bool is_comparable = other.mission != wall.mission && other.room == wall.room;
        if (!is_comparable || way.norm() <= 0.0) continue;
        if (std::abs(way.dot(along)) < kWallCosine * way.norm() * length_m) continue;
        nearest_m = std::min(nearest_m, distance(other.edge, at));
      }
      if (nearest_m >= kWallReachM) continue;
      squares[wall.mission] += nearest_m * nearest_m;
      samples[wall.mission] += 1.0;
    }
  }
  for (std::size_t i = 0; i < missions.size(); ++i) {
    missions[i].walls_compared_m = samples[i] * kWallStepM;
    missions[i].walls_rms_m = root_mean(squares[i], samples[i]);
  }
}

std::vector<MissionPair> pairs_of(const std::vector<Closure>& closures, const Placement& placement,
                                  const std::map<AsrId, std::size_t>& mission_of) {
  struct Sums {
    MissionPair pair;
    double squares_m2 = 0.0;
    double squares_deg2 = 0.0;
  };
  std::map<std::pair<std::size_t, std::size_t>, Sums> sums;
  for (const Closure& closure : closures) {
    const auto from = mission_of.find(closure.from);
    const auto to = mission_of.find(closure.to);
    const bool is_between =
        from != mission_of.end() && to != mission_of.end() && from->second != to->second;
    if (!is_between) continue;
    Sums& sum = sums[std::minmax(from->second, to->second)];
    if (closure.verdict != ClosureVerdict::accepted) {
      ++sum.pair.refused;
      continue;
    }
    ++sum.pair.accepted;
    const Pose2 placed = inverse(placement.at(closure.from)) * placement.at(closure.to);
    const Pose2 off = inverse(closure.match.first_from_second) * placed;
    sum.squares_m2 += off.position().squaredNorm();
    sum.squares_deg2 += degrees(off.theta_rad) * degrees(off.theta_rad);
  }
  std::vector<MissionPair> pairs;
  for (auto& [missions, sum] : sums) {
    MissionPair pair = sum.pair;
    pair.first = missions.first;
    pair.second = missions.second;
    pair.rms_m = root_mean(sum.squares_m2, pair.accepted);
    pair.rms_deg = root_mean(sum.squares_deg2, pair.accepted);
    pairs.push_back(pair);
  }
  return pairs;
}

}  // namespace

MissionsFigures mission_figures(const AsrSource& source, const Placement& placement,
                                const std::vector<MemberMission>& members,
                                const std::vector<Closure>& closures, const FloorPlan& plan) {
  MissionsFigures figures;
  const RoomRaster raster(plan, kCellM);
  for (const auto& room : raster.points()) {
    figures.floor_m2 += static_cast<double>(room.size()) * kCellM * kCellM;
  }
  std::vector<PlacedWall> walls;
  std::map<AsrId, std::size_t> mission_of;
  std::map<AsrId, RoomId> room_of;
  for (const PlanRoom& room : plan.rooms) {
    for (const AsrId id : room.asrs) room_of[id] = room.id;
  }
  const std::vector<AsrId> ids = source.ids();
  for (std::size_t i = 0; i < members.size(); ++i) {
    MissionFigures mission;
    mission.name = members[i].name;
    mission.sensor = members[i].sensor;
    Observer observer(plan, raster);
    bool is_first = true;
    for (const AsrId id : ids) {
      if (id < members[i].first_asr || id > members[i].last_asr) continue;
      const Asr asr = source.get(id, AsrDetail::path);
      const Pose2& pose = placement.at(id);
      mission_of[id] = i;
      mission.path_length_m += path_length_m(asr);
      mission.first_s = is_first ? asr.start_s : std::min(mission.first_s, asr.start_s);
      mission.last_s = is_first ? asr.end_s : std::max(mission.last_s, asr.end_s);
      is_first = false;
      observer.take(asr, pose);
      const auto room = room_of.find(id);
      if (room == room_of.end()) continue;
      const std::vector<PlacedWall> seen = walls_of(asr, pose, i, room->second);
      walls.insert(walls.end(), seen.begin(), seen.end());
    }
    observer.put_into(mission);
    figures.missions.push_back(std::move(mission));
  }
  compare_walls(walls, figures.missions);
  figures.pairs = pairs_of(closures, placement, mission_of);
  return figures;
}

}  // namespace roomatlas
