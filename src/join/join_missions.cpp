// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/join/join_missions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "joint_graph.hpp"
#include "packed.hpp"
#include "visits_near.hpp"

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

/// What is joined so far, in one frame.
class Component {
 public:
  Component(const MissionMap& base, const JoinOptions& options, const Workers& workers)
      : options_(options),
        workers_(workers),
        index_(sketch_of(base), options.place.locate),
        near_(options.near_m) {
    for (const AsrShape& shape : base.shapes) {
      placement_[shape.id] = base.mission_from_asr.at(shape.id);
    }
    take_in(base);
  }

  [[nodiscard]] std::size_t missions() const { return missions_.size(); }
  [[nodiscard]] double known_m2() const { return index_.seen().known_m2(); }
  [[nodiscard]] const Placement& placement() const { return placement_; }
  [[nodiscard]] const std::vector<Closure>& closures() const { return closures_; }

  [[nodiscard]] MissionSearch search(const MissionMap& mission, const Progress& progress) const {
    MissionSearch search = place_mission(mission, index_, options_.place, progress, workers_);
    const bool is_open = search.verdict == PlaceVerdict::nothing_in_common &&
                         may_be_refurnished(search.places, options_.place);
    if (is_open && is_borne_out(mission, search.places)) search.verdict = PlaceVerdict::placed;
    return search;
  }

  void join(const MissionMap& mission, const MissionPlace& place) {
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

  /// Once all are placed: every visit is matched again with those of other missions that came to
  /// lie near, farther around, and what was found before is forgotten.
  void match_again(double loss_width = 1.0) {
    VisitsNear near(options_.near_m);
    closures_.clear();
    for (const MissionMap* mission : missions_) {
      const std::vector<Closure> found = matched(*mission, near, options_.again_window);
      closures_.insert(closures_.end(), found.begin(), found.end());
      for (const AsrShape& shape : mission->shapes) near.add(shape, placement_.at(shape.id));
    }
    solve(loss_width);
  }

  /// Where matches that readings bear out were thrown out, a mission may lie where it bent to, held
  /// there by false matches of what looks alike. All is matched again, under losses that are wide
  /// first and narrow to what they are (graduated non-convexity, Blake and Zisserman 1987).
  /// @returns whether the matches that hold have more in common since; else all is as it was
  bool straighten() {
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

 private:
  /// Whether readings put the mission where its walls do.
  [[nodiscard]] bool is_borne_out(const MissionMap& mission,
                                  const std::vector<MissionPlace>& places) const {
    if (mission.rays.empty()) return false;
    const JudgedPlaces judged =
        judge_places(places, asked_visits(mission), index_.seen(), mission.sensor, options_.judge);
    return judged.first_is_right >= options_.sure_by_readings &&
           judged.places[0].building_from_mission == places[0].building_from_mission;
  }

  struct Pair {
    const AsrShape* first = nullptr;
    const AsrShape* second = nullptr;
    double apart_m = 0.0;
  };

  /// By one for all: then no rounding of another machine moves anything.
  void solve(double loss_width = 1.0) {
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

  /// Moves the mission against what is joined; where that cannot be without a contradiction, all is
  /// as it was.
  bool moved_alone(const MissionMap& mission, const std::vector<Closure>& found) {
    Placement before;
    for (const AsrShape& shape : mission.shapes) before[shape.id] = placement_.at(shape.id);
    std::vector<Closure> tried = found;
    if (solve_alone(mission, options_, placement_, tried)) return true;
    for (const auto& [id, pose] : before) placement_[id] = pose;
    return false;
  }

  void take_in(const MissionMap& mission) {
    missions_.push_back(&mission);
    for (const AsrShape& shape : mission.shapes) {
      shapes_[shape.id] = {&shape, mission.sensor};
      near_.add(shape, placement_.at(shape.id));
    }
  }

  /// Each visit with the nearest ones of other missions that are joined already.
  /// @param visits where these are
  [[nodiscard]] std::vector<Closure> matched(const MissionMap& mission, const VisitsNear& visits,
                                             const SearchWindow& window) const {
    std::vector<Pair> pairs;
    for (const AsrShape& shape : mission.shapes) {
      const std::vector<Pair> near = nearest_to(shape, visits);
      pairs.insert(pairs.end(), near.begin(), near.end());
    }
    return made_by<Closure>(workers_, pairs.size(), workers_.jobs(),
                            [&](std::size_t k) { return tried(pairs[k], mission.sensor, window); });
  }

  [[nodiscard]] std::vector<Pair> nearest_to(const AsrShape& shape,
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

  [[nodiscard]] Closure tried(const Pair& pair, SensorKind sensor,
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

  /// Points in common of the matches that hold.
  [[nodiscard]] static double holding(const std::vector<Closure>& closures) {
    double score = 0.0;
    for (const Closure& closure : closures) {
      if (closure.verdict == ClosureVerdict::accepted) score += closure.score();
    }
    return score;
  }

  /// Whether solving threw out a match that readings do not contradict. Whatever the sensors, it
  /// has the points that one of lasers must have: few of a sonar are no reason to look again.
  [[nodiscard]] bool throws_out() const {
    return std::any_of(closures_.begin(), closures_.end(), [&](const Closure& closure) {
      return closure.verdict == ClosureVerdict::contradicted &&
             judge(closure.match, options_.min_agreeing, options_.min_agreement) ==
                 ClosureVerdict::accepted;
    });
  }

  struct Known {
    const AsrShape* shape = nullptr;
    SensorKind sensor = SensorKind::laser;
  };

  const JoinOptions& options_;
  const Workers& workers_;
  BuildingIndex index_;
  VisitsNear near_;
  std::map<AsrId, Known> shapes_;
  std::vector<const MissionMap*> missions_;
  Placement placement_;
  std::vector<Closure> closures_;
  double visits_since_ = 0.0;  ///< that joined since all were solved together
};

void note(const MissionSearch& search, JoinedMission& mission) {
  mission.verdict = search.verdict;
  mission.best = search.places.empty() ? MissionPlace{} : search.places[0];
  mission.runner_up_score = search.places.size() > 1 ? search.places[1].score : 0.0;
}

/// Looks for missions as each of their answers has them.
class AnswerSearch {
 public:
  AnswerSearch(const std::vector<MissionMap>& missions, const PlaceMissionOptions& options)
      : missions_(missions), options_(options) {}

  struct Found {
    const MissionMap* map = nullptr;  ///< of the answer that is borne out, or of the first
    MissionSearch search;
  };
  Found in(const Component& component, std::size_t mission, const Progress& progress) {
    const MissionMap& first = missions_[mission];
    Found found{&first, component.search(first, progress)};
    if (first.other_answer.empty()) return found;
    // What the mission measured was measured for the first.
    const auto entry = others_.try_emplace(
        mission, MissionMap{first.shapes, first.other_answer, first.sensor, {}, {}, first.rays});
    const MissionMap& other = entry.first->second;
    MissionSearch of_other = component.search(other, progress);
    if (is_better(of_other, found.search)) found = {&other, std::move(of_other)};
    return found;
  }

 private:
  [[nodiscard]] bool is_better(const MissionSearch& other, const MissionSearch& first) const {
    if (other.verdict != PlaceVerdict::placed) return false;
    if (first.verdict != PlaceVerdict::placed) return true;
    const double score = other.places[0].score;
    return score - first.places[0].score >=
           options_.min_margin + options_.margin_sigmas * std::sqrt(score);
  }

  const std::vector<MissionMap>& missions_;
  const PlaceMissionOptions& options_;
  std::map<std::size_t, MissionMap> others_;
};

/// Where a mission was looked for in another building says nothing of the one that it founds.
void forget_search(JoinedMission& base) {
  base.best = {};
  base.runner_up_score = 0.0;
}

}  // namespace

JoinedMissions join_missions(const std::vector<MissionMap>& missions, const JoinOptions& options,
                             const Progress& progress, const Workers& workers) {
  JoinedMissions joined;
  joined.missions.resize(missions.size());
  AnswerSearch answers(missions, options.place);
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < missions.size(); ++i) open.push_back(i);
  for (int number = 0; !open.empty(); ++number) {
    Component component(missions[open.front()], options, workers);
    const std::size_t base = open.front();
    joined.missions[base].component = number;
    joined.missions[base].is_base = true;
    open.erase(open.begin());
    // Whoever found no place is tried again once the component knows more than it did then.
    std::map<std::size_t, double> known_then_m2;
    for (std::size_t size_before = 0; size_before != component.missions();) {
      size_before = component.missions();
      for (auto at = open.begin(); at != open.end();) {
        const auto tried = known_then_m2.find(*at);
        const double known_m2 = component.known_m2();
        if (tried != known_then_m2.end() && known_m2 - tried->second < options.search_growth_m2) {
          ++at;
          continue;
        }
        known_then_m2[*at] = known_m2;
        report(progress, "join missions",
               1.0 - static_cast<double>(open.size()) / static_cast<double>(missions.size()));
        JoinedMission& mission = joined.missions[*at];
        const auto [map, search] = answers.in(component, *at, progress);
        if (number == 0 || search.verdict == PlaceVerdict::placed) note(search, mission);
        if (search.verdict != PlaceVerdict::placed) {
          ++at;
          continue;
        }
        component.join(*map, search.places[0]);
        mission.component = number;
        mission.is_other_answer = map != &missions[*at];
        at = open.erase(at);
      }
    }
    for (int round = 0; component.missions() > 1 && round < options.rounds; ++round) {
      report(progress, "join missions again", static_cast<double>(round) / options.rounds);
      component.match_again();
    }
    for (int round = 0; component.missions() > 1 && round < options.straightenings; ++round) {
      if (!component.straighten()) break;
    }
    if (component.missions() > 1) forget_search(joined.missions[base]);
    joined.placement.insert(component.placement().begin(), component.placement().end());
    joined.closures.insert(joined.closures.end(), component.closures().begin(),
                           component.closures().end());
  }
  return joined;
}

}  // namespace roomatlas
