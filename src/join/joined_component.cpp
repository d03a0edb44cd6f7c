// SPDX-License-Identifier: GPL-3.0-or-later
#include "joined_component.hpp"

#include <algorithm>
#include <set>

#include "joint_graph.hpp"
#include "packed.hpp"

namespace roomatlas {
namespace {

/// What comes out of solving, to be handed on.
struct Solved {
  std::vector<Pose2> poses;  ///< ascending by the visits' ids
  std::vector<ClosureVerdict> verdicts;
};

template <MaybeConst<Solved> Value, typename Visit>
void fields_of(Value& solved, Visit& visit) {
  visit(solved.poses, solved.verdicts);
}

std::vector<Pose2> poses_of(const Placement& placement) {
  std::vector<Pose2> poses;
  poses.reserve(placement.size());
  for (const auto& [id, pose] : placement) poses.push_back(pose);
  return poses;
}

std::vector<ClosureVerdict> verdicts_of(const std::vector<Closure>& closures) {
  std::vector<ClosureVerdict> verdicts;
  verdicts.reserve(closures.size());
  for (const Closure& closure : closures) verdicts.push_back(closure.verdict);
  return verdicts;
}

/// What the visits saw that lie in what is known; how a mission bent beyond it says nothing.
std::vector<AskedVisit> asked_inside(const MissionMap& mission, const MissionPlace& place) {
  std::set<AsrId> inside;
  for (const PlacedPiece& piece : place.pieces) {
    if (piece.is_inside) inside.insert(piece.visits.begin(), piece.visits.end());
  }
  std::vector<AskedVisit> asked = asked_visits(mission);
  std::erase_if(asked, [&](const AskedVisit& visit) { return !inside.contains(visit.id); });
  return asked;
}

/// Points in common of the matches that hold.
double holding(const std::vector<Closure>& closures) {
  double score = 0.0;
  for (const Closure& closure : closures) {
    if (closure.verdict == ClosureVerdict::accepted) score += closure.score();
  }
  return score;
}

}  // namespace

JoinedComponent::JoinedComponent(const MissionMap& base, const JoinOptions& options,
                                 const Workers& workers)
    : options_(options),
      workers_(workers),
      index_(sketch_of(base), options.place.locate),
      near_(options.near_m) {
  for (const AsrShape& shape : base.shapes) {
    placement_[shape.id] = base.mission_from_asr.at(shape.id);
  }
  take_in(base);
}

MissionSearch JoinedComponent::search(const MissionMap& mission, const Progress& progress) const {
  MissionSearch search = place_mission(mission, index_, options_.place, progress, workers_);
  if (mission.sensor != SensorKind::laser || mission.rays.empty()) return search;
  const bool is_placed = search.verdict == PlaceVerdict::placed;
  const bool is_open = is_placed ? search.places[0].score < options_.place.sure_score
                                 : search.verdict == PlaceVerdict::nothing_in_common &&
                                       may_be_refurnished(search.places, options_.place);
  if (!is_open) return search;
  search.verdict =
      is_borne_out(mission, search.places) ? PlaceVerdict::placed : PlaceVerdict::nothing_in_common;
  return search;
}

void JoinedComponent::join(const MissionMap& mission, const MissionPlace& place) {
  for (const PlacedPiece& piece : place.pieces) {
    for (const AsrId id : piece.visits) {
      placement_[id] = piece.place.building_from_query * mission.mission_from_asr.at(id);
    }
  }
  std::vector<Closure> found = matched(mission, near_, options_.window);
  visits_since_ += static_cast<double>(mission.shapes.size());
  const auto visits = static_cast<double>(shapes_.size() + mission.shapes.size());
  const bool is_moved =
      visits_since_ < options_.solve_growth * visits && moved_alone(mission, found);
  closures_.insert(closures_.end(), found.begin(), found.end());
  take_in(mission);
  if (!is_moved) {
    solve();
    visits_since_ = 0.0;
  }
  MissionMap placed{mission.shapes, {}, mission.sensor, {}, {}, {}};
  for (const AsrShape& shape : mission.shapes) {
    placed.mission_from_asr[shape.id] = placement_.at(shape.id);
  }
  index_.add(sketch_of(placed));
}

void JoinedComponent::match_again(double loss_width) {
  VisitsNear near(options_.near_m);
  closures_.clear();
  for (const MissionMap* mission : missions_) {
    const std::vector<Closure> found = matched(*mission, near, options_.again_window);
    closures_.insert(closures_.end(), found.begin(), found.end());
    for (const AsrShape& shape : mission->shapes) near.add(shape, placement_.at(shape.id));
  }
  solve(loss_width);
}

bool JoinedComponent::straighten() {
  if (!throws_out()) return false;
  const Placement placement = placement_;
  const std::vector<Closure> closures = closures_;
  const double before = holding(closures_);
  for (const double width : {64.0, 16.0, 4.0, 1.0}) match_again(width);
  if (holding(closures_) > before) return true;
  placement_ = placement;
  closures_ = closures;
  return false;
}

bool JoinedComponent::is_borne_out(const MissionMap& mission,
                                   const std::vector<MissionPlace>& places) const {
  constexpr std::size_t kOnce = 1;
  const std::vector<char> borne_out = made_by<char>(workers_, kOnce, 1, [&](std::size_t) {
    const JudgedPlaces judged = judge_places(places, asked_inside(mission, places[0]),
                                             index_.seen(), mission.sensor, options_.judge);
    const bool is_sure = judged.first_is_right >= options_.sure_by_readings;
    const bool is_same = judged.places[0].building_from_mission == places[0].building_from_mission;
    return static_cast<char>(is_sure && is_same ? 1 : 0);
  });
  return borne_out.front() != 0;
}

void JoinedComponent::solve(double loss_width) {
  if (!workers_.is_shared())
    return solve_joint(missions_, options_, placement_, closures_, loss_width);
  constexpr std::size_t kOnce = 1;
  const Solved solved = made_by<Solved>(workers_, kOnce, 1, [&](std::size_t) {
                          solve_joint(missions_, options_, placement_, closures_, loss_width);
                          return Solved{poses_of(placement_), verdicts_of(closures_)};
                        }).front();
  std::size_t i = 0;
  for (auto& [id, pose] : placement_) pose = solved.poses[i++];
  for (std::size_t k = 0; k < closures_.size(); ++k) closures_[k].verdict = solved.verdicts[k];
}

bool JoinedComponent::moved_alone(const MissionMap& mission, const std::vector<Closure>& found) {
  Placement before;
  for (const AsrShape& shape : mission.shapes) before[shape.id] = placement_.at(shape.id);
  std::vector<Closure> tried = found;
  if (solve_alone(mission, options_, placement_, tried)) return true;
  for (const auto& [id, pose] : before) placement_[id] = pose;
  return false;
}

void JoinedComponent::take_in(const MissionMap& mission) {
  missions_.push_back(&mission);
  for (const AsrShape& shape : mission.shapes) {
    shapes_[shape.id] = {&shape, mission.sensor};
    near_.add(shape, placement_.at(shape.id));
  }
}

std::vector<Closure> JoinedComponent::matched(const MissionMap& mission, const VisitsNear& visits,
                                              const SearchWindow& window) const {
  std::vector<Pair> pairs;
  for (const AsrShape& shape : mission.shapes) {
    const std::vector<Pair> near = nearest_to(shape, visits);
    pairs.insert(pairs.end(), near.begin(), near.end());
  }
  return made_by<Closure>(workers_, pairs.size(), workers_.jobs(),
                          [&](std::size_t k) { return tried(pairs[k], mission.sensor, window); });
}

std::vector<JoinedComponent::Pair> JoinedComponent::nearest_to(const AsrShape& shape,
                                                               const VisitsNear& visits) const {
  std::vector<Pair> near;
  const Pose2& pose = placement_.at(shape.id);
  for (const AsrId id : visits.near(shape, pose)) {
    const AsrShape& other = *shapes_.at(id).shape;
    const double apart_m = path_distance_m(other, shape, inverse(placement_.at(id)) * pose);
    if (apart_m <= options_.near_m) near.push_back({&other, &shape, apart_m});
  }
  std::stable_sort(near.begin(), near.end(),
                   [](const Pair& a, const Pair& b) { return a.apart_m < b.apart_m; });
  near.resize(std::min(near.size(), static_cast<std::size_t>(options_.max_matches)));
  return near;
}

Closure JoinedComponent::tried(const Pair& pair, SensorKind sensor,
                               const SearchWindow& window) const {
  Closure closure;
  closure.from = pair.first->id;
  closure.to = pair.second->id;
  const Pose2 guess = inverse(placement_.at(closure.from)) * placement_.at(closure.to);
  closure.match =
      SearchableMap(pair.first->map, options_.match).find(pair.second->points, guess, window);
  const bool is_laser =
      sensor == SensorKind::laser && shapes_.at(pair.first->id).sensor == SensorKind::laser;
  closure.verdict =
      judge(closure.match, is_laser ? options_.min_agreeing : options_.min_agreeing_sonar,
            options_.min_agreement);
  return closure;
}

bool JoinedComponent::throws_out() const {
  return std::any_of(closures_.begin(), closures_.end(), [&](const Closure& closure) {
    return closure.verdict == ClosureVerdict::contradicted &&
           judge(closure.match, options_.min_agreeing, options_.min_agreement) ==
               ClosureVerdict::accepted;
  });
}

}  // namespace roomatlas
