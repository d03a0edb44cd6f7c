// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/loops/close_loops.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "rival_loops.hpp"
#include "roomatlas/core/evenly.hpp"
#include "roomatlas/core/for_each_index.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/core/progress.hpp"
#include "wider_matches.hpp"

namespace roomatlas {
namespace {

SearchWindow window_of(const Uncertainty& between, const ClosureOptions& options) {
  return {std::clamp(options.window_sigmas * between.position_m, options.min_window.reach_m,
                     options.max_window.reach_m),
          std::clamp(options.window_sigmas * between.heading_rad, options.min_window.reach_rad,
                     options.max_window.reach_rad)};
}

class LoopCloser {
 public:
  LoopCloser(const DrivenRooms& rooms, const CorrectOptions& correct, const ClosureOptions& options,
             const Progress& progress, int jobs)
      : asrs_(rooms.asrs),
        shapes_(rooms.shapes),
        options_(options),
        progress_(progress),
        jobs_(jobs),
        passage_robust_sigmas_(correct.passage_robust_sigmas),
        state_{PlacedGraph(options.robust_sigmas), {}, {}, {}} {
    std::map<AsrId, std::size_t> index_of;
    for (std::size_t i = 0; i < asrs_.size(); ++i) index_of[asrs_[i].id] = i;
    into_.resize(asrs_.size());
    for (const PassageEdge& edge : rooms.graph.edges) {
      if (index_of.at(edge.from) >= index_of.at(edge.to)) continue;
      into_[index_of.at(edge.to)] = {index_of.at(edge.from), edge.from_from_to,
                                     information_of(edge, correct)};
    }
    component_ = components_of(rooms.graph);
  }

  ClosedLoops run() {
    for (std::size_t i = 0; i < asrs_.size(); ++i) {
      report(progress_, "match rooms", share_of(i, asrs_.size()));
      enter(i);
    }
    state_.placed.solve();
    for (int round = 1; round < options_.rounds; ++round) match_all_again(false);
    mend();
    ClosedLoops result;
    if (const auto rival = rival_of(state_, tried_, asrs_.size(), cell_m())) {
      result.second = rival->second;
      result.second->other = placement_in(options_.take_second ? state_ : tried_[rival->which]);
      if (options_.take_second) take(tried_[rival->which]);
    }
    match_all_again(true);
    result.lost_before = state_.lost_before;
    result.closures = std::move(state_.closures);
    result.placement = placement_in(state_);
    return result;
  }

 private:
  [[nodiscard]] Placement placement_in(const LoopsState& state) const {
    Placement placement;
    for (std::size_t i = 0; i < asrs_.size(); ++i) placement[asrs_[i].id] = state.placed.pose(i);
    return placement;
  }

  struct DrivenInto {
    std::size_t from = 0;
    Pose2 from_from_to;
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  };

  /// Adds an ASR to the graph and matches it with the earlier ones that lie near.
  void enter(std::size_t i) {
    const auto& into = into_[i];
    state_.placed.add_node(asrs_[i].id, into ? state_.placed.pose(into->from) * into->from_from_to
                                             : asrs_[i].odom_from_asr);
    if (into) state_.placed.add_driven(into->from, i, into->from_from_to, into->information);
    std::vector<Pair> pairs;
    const double reach_m = options_.near_m + options_.max_near_growth_m;
    for (std::size_t earlier = 0; earlier < i; ++earlier) consider(earlier, i, reach_m, pairs);
    const std::vector<Uncertainty> uncertainties = state_.placed.uncertainties(pairs);
    std::vector<std::pair<Pair, Uncertainty>> near;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const double growth_m =
          std::min(options_.max_near_growth_m, 2.0 * uncertainties[k].position_m);
      if (pairs[k].apart_m <= options_.near_m + growth_m)
        near.emplace_back(pairs[k], uncertainties[k]);
    }
    std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) {
      return a.first.apart_m < b.first.apart_m;
    });
    if (near.size() > static_cast<std::size_t>(options_.max_candidates)) {
      near.resize(static_cast<std::size_t>(options_.max_candidates));
    }
    const auto matches = results_of<MapMatch>(near.size(), jobs_, [&](std::size_t k) {
      const auto& [pair, between] = near[k];
      return SearchableMap(shapes_[pair.first].map, options_.match)
          .find(shapes_[pair.second].points, state_.placed.first_from_second(pair),
                window_of(between, options_));
    });
    bool any = false;
    for (std::size_t k = 0; k < near.size(); ++k) {
      if (is_rejected(near[k].first)) continue;
      if (verdict_on(matches[k], options_.min_agreeing) != ClosureVerdict::accepted) continue;
      state_.placed.add(near[k].first, matches[k]);
      any = true;
    }
    if (any) state_.placed.solve();
  }

  /// Two ASRs each that lie near to each other, by first, then second.
  [[nodiscard]] std::vector<Pair> pairs_again() const {
    std::vector<Pair> pairs;
    for (std::size_t second = 1; second < asrs_.size(); ++second) {
      const std::size_t before = pairs.size();
      for (std::size_t first = 0; first < second; ++first) {
        consider(first, second, options_.again_near_m, pairs);
      }
      keep_evenly(static_cast<std::size_t>(options_.again_max_candidates), pairs, before);
    }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Pair& a, const Pair& b) { return a.first < b.first; });
    return pairs;
  }

  /// Matches ASRs that lie near to each other, and forgets the matches before.
  void match_all_again(bool is_last) {
    const std::vector<Pair> pairs = pairs_again();
    std::vector<Uncertainty> uncertainties(pairs.size());
    if (!is_last) uncertainties = state_.placed.uncertainties(pairs);
    const std::vector<MapMatch> matches = matches_of(pairs, uncertainties);
    state_.closures.clear();
    state_.pairs = pairs;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      state_.closures.push_back({asrs_[pairs[k].first].id, asrs_[pairs[k].second].id, matches[k],
                                 verdict_on(matches[k], options_.again_min_agreeing), false});
      if (is_rejected(pairs[k])) state_.closures.back().verdict = ClosureVerdict::left_out;
    }
    try_given();
    if (is_last) leave_out_best();
    state_.placed.remove_closures();
    for (std::size_t k = 0; k < state_.pairs.size(); ++k) {
      if (state_.closures[k].verdict != ClosureVerdict::accepted) continue;
      state_.placed.add(state_.pairs[k], state_.closures[k].match);
    }
    state_.placed.solve();
  }

  /// Matches pairs that stand in the order of their first rooms, each room's map made once.
  [[nodiscard]] std::vector<MapMatch> matches_of(
      const std::vector<Pair>& pairs, const std::vector<Uncertainty>& uncertainties) const {
    std::vector<std::size_t> begins;  // of the pairs of each first room
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      if (k == 0 || pairs[k].first != pairs[k - 1].first) begins.push_back(k);
    }
    begins.push_back(pairs.size());
    std::vector<MapMatch> matches(pairs.size());
    const auto match_all_of = [&](std::size_t room) {
      const SearchableMap map(shapes_[pairs[begins[room]].first].map, options_.match);
      for (std::size_t k = begins[room]; k < begins[room + 1]; ++k) {
        matches[k] =
            map.find(shapes_[pairs[k].second].points, state_.placed.first_from_second(pairs[k]),
                     window_of(uncertainties[k], options_));
      }
    };
    for_each_index(begins.size() - 1, jobs_, match_all_of, [&](std::size_t room) {
      report(progress_, "match rooms again", share_of(begins[room], pairs.size()));
    });
    return matches;
  }

  /// Rooms that lie on each other and contradict each other: some of them lie elsewhere. They are
  /// sought in a wider window. Those that would move alike are believed together, and kept where
  /// all rooms, matched again from there, agree better than before; else the next of them are.
  void mend() {
    std::vector<WiderMatch> found = search_wider();
    for (int tries = 0; tries < options_.max_mends && !found.empty(); ++tries) {
      const std::vector<WiderMatch> alike = take_most_alike(found);
      if (gain_of(alike) < options_.mend_seed * state_.total_score()) return;  // the rest gain less
      if (believe(alike)) found = search_wider();
    }
  }

  /// Places all rooms with these matches believed, where that is better: with the passages as they
  /// are, and from there with those giving way in which the robot may have been lost. Were they
  /// doubted at once, rooms that look alike in a row would hold on to their neighbours' places.
  bool believe(const std::vector<WiderMatch>& matches) {
    LoopsState best = state_;
    double best_score = options_.mend_gain * state_.total_score();
    const double most_contradicted = options_.mend_relief * state_.contradicted_share();
    bool is_better = false;
    for (const WiderMatch& wider : matches) {
      state_.placed.add_believed(state_.pairs[wider.pair], wider.match);
    }
    for (const bool doubt_passages : {false, true}) {
      if (doubt_passages) state_.placed.doubt_passages(passage_robust_sigmas_);
      state_.placed.solve();
      match_all_again(false);
      const bool is_worse =
          state_.total_score() <= best_score || state_.contradicted_share() > most_contradicted;
      tried_.push_back(is_worse ? state_ : std::exchange(best, state_));
      if (is_worse) continue;
      best_score = state_.total_score();
      is_better = true;
    }
    state_ = std::move(best);
    if (is_better) state_.lost_before = state_.placed.keep_doubts();
    return is_better;
  }

  /// Of the contradicted pairs those that fit elsewhere.
  [[nodiscard]] std::vector<WiderMatch> search_wider() const {
    std::vector<std::size_t> contradicted;
    for (std::size_t k = 0; k < state_.pairs.size(); ++k) {
      if (state_.closures[k].verdict == ClosureVerdict::contradicted) contradicted.push_back(k);
    }
    const auto matches = results_of<MapMatch>(contradicted.size(), jobs_, [&](std::size_t i) {
      const Pair& pair = state_.pairs[contradicted[i]];
      return SearchableMap(shapes_[pair.first].map, options_.match)
          .find(shapes_[pair.second].points, state_.placed.first_from_second(pair),
                options_.max_window);
    });
    std::vector<WiderMatch> found;
    for (std::size_t i = 0; i < contradicted.size(); ++i) {
      const std::size_t k = contradicted[i];
      const MapMatch& match = matches[i];
      if (verdict_on(match, options_.min_agreeing) != ClosureVerdict::accepted) continue;
      const Closure there{0, 0, match, ClosureVerdict::accepted, false};
      found.push_back({k, match, there.score() - state_.closures[k].score(),
                       state_.placed.pose(state_.pairs[k].second),
                       state_.placed.pose(state_.pairs[k].first) * match.first_from_second});
    }
    return found;
  }

  void take(const LoopsState& state) {
    state_ = state;
    if (state_.lost_before.empty()) state_.lost_before = state_.placed.keep_doubts();
  }

  [[nodiscard]] double cell_m() const {
    return shapes_.empty() ? 0.0 : shapes_.front().map.frame().cell_m;
  }

  [[nodiscard]] std::size_t index_of(AsrId id) const {
    const auto at =
        std::find_if(asrs_.begin(), asrs_.end(), [&](const Asr& asr) { return asr.id == id; });
    if (at == asrs_.end()) {
      throw InputError("added closure: there is no ASR " + std::to_string(id) +
                       "; the store has 1 to " + std::to_string(asrs_.back().id));
    }
    return static_cast<std::size_t>(at - asrs_.begin());
  }

  /// Measurements of the user, sought where they say.
  void try_given() {
    for (const GivenClosure& given : options_.given) {
      const Pair pair{index_of(given.from), index_of(given.to), 0.0};
      const MapMatch match =
          SearchableMap(shapes_[pair.first].map, options_.match)
              .find(shapes_[pair.second].points, given.from_from_to, options_.min_window);
      state_.pairs.push_back(pair);
      state_.closures.push_back(
          {given.from, given.to, match, verdict_on(match, options_.again_min_agreeing), true});
    }
  }

  void leave_out_best() {
    std::vector<Closure*> best;
    for (Closure& closure : state_.closures) {
      if (closure.verdict == ClosureVerdict::accepted) best.push_back(&closure);
    }
    std::stable_sort(best.begin(), best.end(), [](const Closure* first, const Closure* second) {
      return first->score() > second->score();
    });
    const auto count = static_cast<std::size_t>(std::max(0, options_.without_best));
    for (std::size_t i = 0; i < std::min(count, best.size()); ++i) {
      best[i]->verdict = ClosureVerdict::left_out;
    }
  }

  void consider(std::size_t first, std::size_t second, double reach_m,
                std::vector<Pair>& pairs) const {
    if (component_[first] != component_[second]) return;
    Pair pair{first, second, 0.0};
    const Pose2 between = state_.placed.first_from_second(pair);
    constexpr double kLongestPieceM = 30.0;  // a visit is cut long before
    if (between.position().norm() > reach_m + 2.0 * kLongestPieceM) return;
    pair.apart_m = path_distance_m(shapes_[first], shapes_[second], between);
    if (pair.apart_m <= reach_m) pairs.push_back(pair);
  }

  [[nodiscard]] bool is_rejected(const Pair& pair) const {
    const std::pair<AsrId, AsrId> ids(asrs_[pair.first].id, asrs_[pair.second].id);
    return std::any_of(options_.rejected.begin(), options_.rejected.end(), [&](const auto& one) {
      return one == ids || one == std::pair(ids.second, ids.first);
    });
  }

  [[nodiscard]] ClosureVerdict verdict_on(const MapMatch& match, int min_agreeing) const {
    return judge(match, min_agreeing, options_.min_agreement);
  }

  const std::vector<Asr>& asrs_;
  const std::vector<AsrShape>& shapes_;
  const ClosureOptions& options_;
  const Progress& progress_;
  int jobs_;
  double passage_robust_sigmas_;
  LoopsState state_;
  std::vector<LoopsState> tried_;  ///< that were not kept
  std::vector<std::optional<DrivenInto>> into_;
  std::vector<int> component_;
};

}  // namespace

ClosedLoops close_loops(const DrivenRooms& rooms, const CorrectOptions& correct,
                        const ClosureOptions& options, const Progress& progress, int jobs) {
  return LoopCloser(rooms, correct, options, progress, jobs).run();
}

}  // namespace roomatlas
