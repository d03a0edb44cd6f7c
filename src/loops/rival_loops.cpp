// SPDX-License-Identifier: GPL-3.0-or-later
#include "rival_loops.hpp"

#include <algorithm>

#include "roomatlas/core/paired_difference.hpp"

namespace roomatlas {
namespace {

constexpr double kElsewhereM = 0.5;    // nearer, two states put a room in one place
constexpr double kNearlyAsWell = 0.8;  // of the score of the kept: less is no second answer

struct Moved {
  std::vector<bool> is_elsewhere;  ///< by ASR
  int count = 0;
  double farthest_m = 0.0;
};

Moved moved_between(const PlacedGraph& kept, const PlacedGraph& other, std::size_t asrs) {
  Moved moved;
  for (std::size_t i = 0; i < asrs; ++i) {
    const double apart_m = (kept.pose(i).position() - other.pose(i).position()).norm();
    moved.is_elsewhere.push_back(apart_m > kElsewhereM);
    moved.count += apart_m > kElsewhereM ? 1 : 0;
    moved.farthest_m = std::max(moved.farthest_m, apart_m);
  }
  return moved;
}

/// Of the matches of rooms that moved, by room: a match speaks for both of its rooms alike.
std::vector<double> scores_of_moved(const LoopsState& state, const Moved& moved) {
  std::vector<double> scores(moved.is_elsewhere.size(), 0.0);
  for (std::size_t k = 0; k < state.pairs.size(); ++k) {
    const Pair& pair = state.pairs[k];
    if (!moved.is_elsewhere[pair.first] && !moved.is_elsewhere[pair.second]) continue;
    scores[pair.first] += state.closures[k].score() / 2.0;
    scores[pair.second] += state.closures[k].score() / 2.0;
  }
  return scores;
}

double sum_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum;
}

}  // namespace

double LoopsState::total_score() const {
  double score = 0.0;
  for (const Closure& closure : closures) score += closure.score();
  return score;
}

double LoopsState::contradicted_share() const {
  double contradicting = 0.0;
  double all = 0.0;
  for (const Closure& closure : closures) {
    contradicting += closure.match.contradicting;
    all += closure.match.contradicting + closure.match.agreeing;
  }
  return all > 0.0 ? contradicting / all : 0.0;
}

std::optional<RivalLoops> rival_of(const LoopsState& kept, const std::vector<LoopsState>& states,
                                   std::size_t asrs, double cell_m) {
  std::optional<RivalLoops> best;
  for (std::size_t which = 0; which < states.size(); ++which) {
    const Moved moved = moved_between(kept.placed, states[which].placed, asrs);
    if (moved.count == 0) continue;
    const std::vector<double> here = scores_of_moved(kept, moved);
    const std::vector<double> there = scores_of_moved(states[which], moved);
    const double score = sum_of(there);
    if (score <= 0.0 || score < kNearlyAsWell * sum_of(here)) continue;
    if (!paired_difference(here, there).is_within_chance()) continue;
    if (best && score * cell_m <= best->second.score_m) continue;
    best = RivalLoops{which,
                      {moved.count, moved.farthest_m, score * cell_m, sum_of(here) * cell_m, {}}};
  }
  return best;
}

}  // namespace roomatlas
