// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/join/join_missions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "joined_component.hpp"

namespace roomatlas {
namespace {

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
  Found in(const JoinedComponent& component, std::size_t mission, const Progress& progress) {
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
    JoinedComponent component(missions[open.front()], options, workers);
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
