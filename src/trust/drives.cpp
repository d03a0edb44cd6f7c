// SPDX-License-Identifier: GPL-3.0-or-later
#include "drives.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "roomatlas/graph/bridges.hpp"

namespace roomatlas {
namespace {

constexpr double kIntoRooms_m = 2.0;  // that a crossing goes on at both ends together, to see walls
constexpr std::size_t kMostEnds = 8;  // of chains that are tried, the farthest: time alone

/// A passage on a way, and whether it is gone through against its direction.
struct Step {
  std::size_t edge = 0;
  AsrId from = 0;
  AsrId to = 0;
};

bool have_wall_directions(const Correction& correction) {
  constexpr double kUsed = 0.5;  // weight of a factor that counts
  return std::any_of(correction.factors.begin(), correction.factors.end(),
                     [](const FactorReport& factor) {
                       return factor.kind == FactorKind::wall_direction && factor.weight >= kUsed;
                     });
}

class Drives {
 public:
  Drives(const Assembly& assembly, const CorrectOptions& correct, const AddedEdges& held,
         double variance_factor)
      : assembly_(assembly),
        graph_(assembly.graph),
        correct_(correct),
        held_(held),
        variance_factor_(variance_factor),
        walls_give_headings_(have_wall_directions(assembly.correction)),
        tie_(variance_factor * tie_covariance()) {
    for (std::size_t i = 0; i < graph_.vertices.size(); ++i) place_of_[graph_.vertices[i].asr] = i;
    for (std::size_t e = 0; e < graph_.edges.size(); ++e) {
      const PassageEdge& edge = graph_.edges[e];
      if (edge.from == edge.to) continue;
      next_[edge.from].push_back({e, edge.from, edge.to});
      next_[edge.to].push_back({e, edge.to, edge.from});
    }
  }

  std::vector<Drive> all() {
    cross_bridges();
    follow_chains();
    use_doors();
    return std::move(drives_);
  }

 private:
  /// Of a visit's pose by walls seen again: the accepted match of rooms in the middle, by its
  /// trace.
  [[nodiscard]] Eigen::Matrix3d tie_covariance() const {
    std::vector<const MapMatch*> matches;
    for (const Closure& closure : assembly_.closures) {
      const bool is_sure = closure.match.information.determinant() > 0.0;
      if (closure.verdict == ClosureVerdict::accepted && is_sure) matches.push_back(&closure.match);
    }
    if (matches.empty()) {
      PassageEdge doorway;
      doorway.source = EdgeSource::recognised;
      Eigen::Matrix3d covariance = information_of(doorway, correct_).inverse();
      if (walls_give_headings_) covariance(2, 2) = std::pow(radians(correct_.wall_heading_deg), 2);
      return covariance;
    }
    std::stable_sort(matches.begin(), matches.end(), [](const MapMatch* a, const MapMatch* b) {
      return a->information.trace() < b->information.trace();
    });
    return matches[matches.size() / 2]->information.inverse();
  }

  [[nodiscard]] RoomId room_of(AsrId asr) const {
    const auto room = assembly_.room_of_asr.find(asr);
    return room == assembly_.room_of_asr.end() ? 0 : room->second;
  }

  /// The end of a drive from its beginning, with the ties at both.
  [[nodiscard]] PoseEdge measured(AsrId from, AsrId to, const Pose2& step,
                                  const Eigen::Matrix3d& on_the_way) const {
    const Point2 along = direction(step.theta_rad);
    const double swings = walls_give_headings_ ? 0.0 : 1.0;
    Eigen::Matrix3d carried;  // of the tie at `from`: its turn swings `to` around
    carried << along.x(), along.y(), swings * (along.y() * step.x_m - along.x() * step.y_m),  //
        -along.y(), along.x(), swings * (along.x() * step.x_m + along.y() * step.y_m),        //
        0.0, 0.0, 1.0;
    const Eigen::Matrix3d covariance = on_the_way + tie_ + carried * tie_ * carried.transpose();
    const Eigen::Matrix3d information = covariance.inverse();
    return {node_of(from),
            node_of(to),
            EdgeKind::odometry,
            step,
            (information + information.transpose()) / 2.0,
            0.0};
  }

  [[nodiscard]] std::int32_t node_of(AsrId asr) const {
    return static_cast<std::int32_t>(place_of_.at(asr));
  }

  /// As a passage is measured that the robot drives without being lost.
  [[nodiscard]] Eigen::Matrix3d covariance_of(const PassageEdge& edge) const {
    return variance_factor_ * information_of(edge, correct_).inverse();
  }

  [[nodiscard]] Pose2 pose_of(AsrId asr) const {
    return assembly_.correction.asrs[place_of_.at(asr)].building_from_asr;
  }

  /// Along these steps; nothing where the plan has no rooms at its ends.
  void offer(AdviceKind kind, std::span<const Step> way) {
    Drive drive;
    drive.advice.kind = kind;
    drive.advice.from = way.front().from;
    drive.advice.to = way.back().to;
    drive.advice.from_room = room_of(drive.advice.from);
    drive.advice.to_room = room_of(drive.advice.to);
    if (drive.advice.from_room == 0 || drive.advice.to_room == 0) return;
    drive.advice.drive_m = kIntoRooms_m;
    for (const Step& step : way) {
      drive.advice.drive_m += graph_.edges[step.edge].from_from_to.position().norm();
    }
    const AsrId from = drive.advice.from;
    const AsrId to = drive.advice.to;
    Eigen::Matrix3d on_the_way = held_.relative(node_of(from), node_of(to));
    if (way.size() == 1) {
      const Eigen::Matrix3d alone = covariance_of(graph_.edges[way.front().edge]);
      if (alone.trace() < on_the_way.trace()) on_the_way = alone;
    }
    drive.edge = measured(from, to, inverse(pose_of(from)) * pose_of(to), on_the_way);
    drive.advice.by_door = way.size() == 1 && is_door_between(drive.advice);
    drives_.push_back(std::move(drive));
  }

  [[nodiscard]] bool is_door_between(const Advice& advice) const {
    const auto ends = std::minmax(advice.from_room, advice.to_room);
    return std::any_of(assembly_.doors.begin(), assembly_.doors.end(), [&](const Door& door) {
      return door.kind == DoorKind::door && door.is_between_rooms() &&
             std::minmax(*door.room_a, *door.room_b) == ends;
    });
  }

  void cross_bridges() {
    for (const Bridge& bridge : bridges_of(graph_)) {
      const PassageEdge& edge = graph_.edges[bridge.edge];
      if (edge.source != EdgeSource::driven) continue;
      offer(AdviceKind::cross_again, std::vector<Step>{{bridge.edge, edge.from, edge.to}});
    }
  }

  /// Shortest ways from the first visit of each component (Dijkstra): of each visit the step into
  /// it, and how far it is.
  struct Ways {
    std::map<AsrId, Step> into;
    std::map<AsrId, double> far_m;
  };
  [[nodiscard]] Ways ways_from_first() const {
    Ways ways;
    for (const AsrVertex& first : graph_.vertices) {
      if (ways.far_m.contains(first.asr)) continue;
      std::map<AsrId, double> open{{first.asr, 0.0}};
      std::map<AsrId, Step> into;
      while (!open.empty()) {
        const auto nearest =
            std::min_element(open.begin(), open.end(),
                             [](const auto& a, const auto& b) { return a.second < b.second; });
        const auto [at, far_m] = *nearest;
        open.erase(nearest);
        ways.far_m[at] = far_m;
        const auto steps = next_.find(at);
        if (steps == next_.end()) continue;
        for (const Step& step : steps->second) {
          if (ways.far_m.contains(step.to)) continue;
          const double there_m = far_m + graph_.edges[step.edge].from_from_to.position().norm();
          const auto known = open.find(step.to);
          if (known != open.end() && known->second <= there_m) continue;
          open[step.to] = there_m;
          into[step.to] = step;
        }
      }
      ways.into.merge(into);
    }
    return ways;
  }

  /// Visits with one neighbour, and the farthest of all.
  [[nodiscard]] std::vector<AsrId> ends_of(const Ways& ways) const {
    std::vector<std::pair<double, AsrId>> ends;
    double farthest_m = 0.0;
    for (const auto& [asr, far_m] : ways.far_m) farthest_m = std::max(farthest_m, far_m);
    for (const auto& [asr, steps] : next_) {
      std::set<AsrId> neighbours;
      for (const Step& step : steps) neighbours.insert(step.to);
      const double far_m = ways.far_m.at(asr);
      if (neighbours.size() == 1 || far_m == farthest_m) ends.emplace_back(-far_m, asr);
    }
    std::sort(ends.begin(), ends.end());
    if (ends.size() > kMostEnds) ends.resize(kMostEnds);
    std::vector<AsrId> list;
    list.reserve(ends.size());
    for (const auto& [minus_m, asr] : ends) list.push_back(asr);
    return list;
  }

  /// The last two passages to an end, the last four, eight ..., and all.
  void follow_chains() {
    const Ways ways = ways_from_first();
    for (const AsrId end : ends_of(ways)) {
      std::vector<Step> way;
      for (auto into = ways.into.find(end); into != ways.into.end();
           into = ways.into.find(into->second.from)) {
        way.push_back(into->second);
      }
      std::reverse(way.begin(), way.end());
      for (std::size_t last = 2; last < 2 * way.size(); last *= 2) {
        offer(AdviceKind::drive_again, std::span(way).last(std::min(last, way.size())));
      }
    }
  }

  /// The visit of a room that begins nearest to a point, in building metres.
  [[nodiscard]] std::optional<AsrCorrection> visit_near(RoomId room, const Point2& point) const {
    std::optional<AsrCorrection> best;
    double best_m = std::numeric_limits<double>::infinity();
    for (const AsrCorrection& asr : assembly_.correction.asrs) {
      const double apart_m = (asr.building_from_asr.position() - point).norm();
      if (room_of(asr.asr) != room || apart_m >= best_m) continue;
      best = asr;
      best_m = apart_m;
    }
    return best;
  }

  /// Doors that were seen, and no drive went between the rooms on their sides.
  void use_doors() {
    std::set<std::pair<RoomId, RoomId>> joined;
    for (const PassageEdge& edge : graph_.edges) {
      joined.insert(std::minmax({room_of(edge.from), room_of(edge.to)}));
    }
    const bool is_localized =
        std::any_of(graph_.edges.begin(), graph_.edges.end(),
                    [](const PassageEdge& edge) { return edge.is_localized; });
    for (const Door& door : assembly_.doors) {
      if (door.is_driven || !door.is_between_rooms() || door.kind == DoorKind::window) continue;
      const std::pair<RoomId, RoomId> rooms = std::minmax({*door.room_a, *door.room_b});
      if (rooms.first == rooms.second || !joined.insert(rooms).second) continue;
      const auto from = visit_near(rooms.first, door.frame_from_pivot.position());
      const auto to = visit_near(rooms.second, door.frame_from_pivot.position());
      if (!from || !to || from->component != to->component) continue;
      PassageEdge edge;
      edge.from = from->asr;
      edge.to = to->asr;
      edge.from_from_to = inverse(from->building_from_asr) * to->building_from_asr;
      edge.path_length_m =
          (from->building_from_asr.position() - door.frame_from_pivot.position()).norm() +
          (to->building_from_asr.position() - door.frame_from_pivot.position()).norm();
      edge.is_localized = is_localized;
      Drive drive;
      drive.advice.kind = AdviceKind::use_door;
      drive.advice.from = from->asr;
      drive.advice.to = to->asr;
      drive.advice.from_room = rooms.first;
      drive.advice.to_room = rooms.second;
      drive.advice.by_door = true;
      drive.advice.drive_m = kIntoRooms_m + edge.path_length_m;
      drive.edge = measured(edge.from, edge.to, edge.from_from_to, covariance_of(edge));
      drives_.push_back(std::move(drive));
    }
  }

  const Assembly& assembly_;
  const RoomGraph& graph_;
  const CorrectOptions& correct_;
  const AddedEdges& held_;
  double variance_factor_;
  bool walls_give_headings_;
  Eigen::Matrix3d tie_;
  std::map<AsrId, std::size_t> place_of_;
  std::map<AsrId, std::vector<Step>> next_;
  std::vector<Drive> drives_;
};

}  // namespace

std::vector<Drive> drives_of(const Assembly& assembly, const CorrectOptions& correct,
                             const AddedEdges& held, double variance_factor) {
  return Drives(assembly, correct, held, variance_factor).all();
}

}  // namespace roomatlas
