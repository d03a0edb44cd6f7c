// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "roomatlas/correct/place.hpp"
#include "roomatlas/evaluate/alignment.hpp"

namespace roomatlas::bench {
namespace {

using Json = nlohmann::json;

constexpr double kLeastExtent_m = 3.0;  // along an axis; less says nothing of its scale

/// One visit: where it is put and where it truly was, means over its poses.
struct Visit {
  AsrId asr = 0;
  RoomId room = 0;       ///< of the plan; 0: none
  RoomId true_room = 0;  ///< in which most of its poses truly were; 0: none
  std::size_t poses = 0;
  double position_m = 0.0;
  double heading_deg = 0.0;
};

std::map<AsrId, RoomId> rooms_of(const FloorPlan& plan) {
  std::map<AsrId, RoomId> room_of;
  for (const PlanRoom& room : plan.rooms) {
    for (const AsrId asr : room.asrs) room_of[asr] = room.id;
  }
  return room_of;
}

RoomId room_at(const FloorPlan& world, const Point2& point) {
  for (const PlanRoom& room : world.rooms) {
    for (const Polygon& part : room.parts) {
      if (contains(part, point)) return room.id;
    }
  }
  return 0;
}

RoomId most_frequent(const std::map<RoomId, std::size_t>& counts) {
  RoomId best = 0;
  std::size_t most = 0;
  for (const auto& [room, count] : counts) {
    if (count <= most) continue;
    most = count;
    best = room;
  }
  return best;
}

MatchedPoses matched(const Trajectory& placed, const Trajectory& truth) {
  return match_poses(placed, truth, {TimeMatch::interpolate, {}});
}

Visit visit_of(const Trajectory& placed, const Trajectory& truth, const Pose2& truth_from_placed,
               const FloorPlan& world) {
  Visit visit;
  const MatchedPoses poses = matched(placed, truth);
  visit.poses = poses.size();
  if (visit.poses == 0) return visit;
  Point2 shift = Point2::Zero();
  Point2 turn = Point2::Zero();
  std::map<RoomId, std::size_t> rooms;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Pose2 fitted = truth_from_placed * poses.estimate_from_robot[i];
    const Pose2& is = poses.truth_from_robot[i];
    shift += fitted.position() - is.position();
    turn += direction(fitted.theta_rad - is.theta_rad);
    ++rooms[room_at(world, is.position())];
  }
  visit.position_m = shift.norm() / static_cast<double>(visit.poses);
  visit.heading_deg = degrees(std::abs(std::atan2(turn.y(), turn.x())));
  visit.true_room = most_frequent(rooms);
  return visit;
}

/// Slope of the estimated over the true coordinates along one axis, less one.
std::optional<double> scale_error(const MatchedPoses& poses, const Pose2& truth_from_placed,
                                  int axis) {
  double true_mean = 0.0;
  double fitted_mean = 0.0;
  std::vector<std::pair<double, double>> pairs;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Pose2 fitted = truth_from_placed * poses.estimate_from_robot[i];
    pairs.emplace_back(poses.truth_from_robot[i].position()[axis], fitted.position()[axis]);
    true_mean += pairs.back().first;
    fitted_mean += pairs.back().second;
  }
  const auto count = static_cast<double>(pairs.size());
  true_mean /= count;
  fitted_mean /= count;
  double both = 0.0;
  double own = 0.0;
  for (const auto& [is, fitted] : pairs) {
    both += (is - true_mean) * (fitted - fitted_mean);
    own += (is - true_mean) * (is - true_mean);
  }
  if (own / count < kLeastExtent_m * kLeastExtent_m / 12.0) return std::nullopt;
  return both / own - 1.0;
}

/// Which visits the plan has in one room against which truly were in one.
Json graph_of_visits(const std::vector<Visit>& visits) {
  std::map<RoomId, std::set<RoomId>> rooms_of_true;
  std::map<RoomId, std::set<RoomId>> true_of_room;
  for (const Visit& visit : visits) {
    if (visit.room == 0 || visit.true_room == 0) continue;
    rooms_of_true[visit.true_room].insert(visit.room);
    true_of_room[visit.room].insert(visit.true_room);
  }
  const auto several = [](const std::map<RoomId, std::set<RoomId>>& groups) {
    return std::count_if(groups.begin(), groups.end(),
                         [](const auto& group) { return group.second.size() > 1; });
  };
  return {{"true_rooms", rooms_of_true.size()},
          {"split", several(rooms_of_true)},
          {"merged", several(true_of_room)}};
}

/// The largest heading error of a room: its visits', each counted by its poses. Rooms are the true
/// ones where these are known.
double worst_room_deg(const std::vector<Visit>& visits) {
  struct Sum {
    double poses = 0.0;
    double heading_deg = 0.0;
  };
  std::map<std::pair<bool, RoomId>, Sum> rooms;
  for (const Visit& visit : visits) {
    const bool is_known = visit.true_room != 0;
    Sum& sum = rooms[{is_known, is_known ? visit.true_room : visit.room}];
    sum.poses += static_cast<double>(visit.poses);
    sum.heading_deg += static_cast<double>(visit.poses) * visit.heading_deg;
  }
  double worst_deg = 0.0;
  for (const auto& [unused, sum] : rooms) {
    worst_deg = std::max(worst_deg, sum.heading_deg / sum.poses);
  }
  return worst_deg;
}

Json json_of(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

}  // namespace

Json judged_by_truth(const GeoPackageStore& store, const Trajectory& truth,
                     const FloorPlan& world) {
  const Correction correction = store.correction();
  const std::map<AsrId, RoomId> room_of = rooms_of(store.plan());
  const MatchedPoses poses = matched(place(store, correction).corrected, truth);
  if (poses.size() < 2) return {{"matched", poses.size()}, {"right", false}};
  const Pose2 truth_from_placed = truth_from_estimate(poses, Alignment::umeyama);
  double square_m2 = 0.0;
  double square_deg2 = 0.0;
  double worst_m = 0.0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Pose2 fitted = truth_from_placed * poses.estimate_from_robot[i];
    const Pose2& is = poses.truth_from_robot[i];
    const double away_m = (fitted.position() - is.position()).norm();
    square_m2 += away_m * away_m;
    square_deg2 += std::pow(degrees(wrap_angle(fitted.theta_rad - is.theta_rad)), 2);
    worst_m = std::max(worst_m, away_m);
  }
  std::vector<Visit> visits;
  Json list = Json::array();
  double worst_visit_m = 0.0;
  double worst_visit_deg = 0.0;
  for (const AsrCorrection& asr : correction.asrs) {
    Trajectory placed;
    for (const PathSample& sample : store.get(asr.asr, AsrDetail::path).path) {
      placed.push_back({sample.timestamp_s, asr.building_from_asr * sample.asr_from_robot});
    }
    Visit visit = visit_of(placed, truth, truth_from_placed, world);
    if (visit.poses == 0) continue;
    visit.asr = asr.asr;
    const auto room = room_of.find(asr.asr);
    if (room != room_of.end()) visit.room = room->second;
    list.push_back({{"asr", visit.asr},
                    {"room", visit.room},
                    {"true_room", visit.true_room},
                    {"poses", visit.poses},
                    {"position_m", visit.position_m},
                    {"heading_deg", visit.heading_deg}});
    worst_visit_m = std::max(worst_visit_m, visit.position_m);
    worst_visit_deg = std::max(worst_visit_deg, visit.heading_deg);
    visits.push_back(visit);
  }
  const auto count = static_cast<double>(poses.size());
  const double worst_heading_deg = worst_room_deg(visits);
  const bool are_places_right = worst_visit_m <= kRightPosition_m;
  return {{"right", are_places_right && worst_heading_deg <= kRightHeading_deg},
          {"strictly_right", are_places_right && worst_visit_deg <= kRightHeading_deg},
          {"poses", truth.size()},
          {"matched", poses.size()},
          {"rms_position_m", std::sqrt(square_m2 / count)},
          {"max_position_m", worst_m},
          {"rms_heading_deg", std::sqrt(square_deg2 / count)},
          {"max_visit_position_m", worst_visit_m},
          {"max_visit_heading_deg", worst_visit_deg},
          {"max_room_heading_deg", worst_heading_deg},
          {"scale_x", json_of(scale_error(poses, truth_from_placed, 0))},
          {"scale_y", json_of(scale_error(poses, truth_from_placed, 1))},
          {"graph", world.rooms.empty() ? Json(nullptr) : graph_of_visits(visits)},
          {"visits", list}};
}

Json own_figures(const GeoPackageStore& store) {
  const std::vector<Closure> closures = store.closures();
  std::map<std::string, int> verdicts;
  for (const Closure& closure : closures) ++verdicts[to_string(closure.verdict)];
  Json matches = Json::array();
  for (const Closure& closure : closures) {
    matches.push_back({{"from", closure.from},
                       {"to", closure.to},
                       {"verdict", to_string(closure.verdict)},
                       {"agreeing", closure.match.agreeing},
                       {"contradicting", closure.match.contradicting}});
  }
  return {{"closures", verdicts}, {"matches", matches}};
}

}  // namespace roomatlas::bench
