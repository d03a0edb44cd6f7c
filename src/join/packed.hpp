// SPDX-License-Identifier: GPL-3.0-or-later
// Results as bytes, for processes of one program on machines of one kind.
#pragma once

#include <string>
#include <vector>

#include "roomatlas/core/packed.hpp"
#include "roomatlas/core/workers.hpp"
#include "roomatlas/join/place_mission.hpp"
#include "roomatlas/loops/closures.hpp"

namespace roomatlas {

template <MaybeConst<PlaceHypothesis> Value, typename Visit>
void fields_of(Value& place, Visit& visit) {
  visit(place.building_from_query, place.agreeing, place.contradicting, place.unseen, place.missing,
        place.score);
}
template <MaybeConst<PlacedPiece> Value, typename Visit>
void fields_of(Value& piece, Visit& visit) {
  visit(piece.visits, piece.place, piece.is_inside, piece.fits);
}
template <MaybeConst<MissionPlace> Value, typename Visit>
void fields_of(Value& place, Visit& visit) {
  visit(place.building_from_mission, place.pieces, place.score, place.agreeing,
        place.contradicting);
}
template <MaybeConst<MapMatch> Value, typename Visit>
void fields_of(Value& match, Visit& visit) {
  visit(match.first_from_second, match.agreeing, match.contradicting, match.unseen,
        match.information);
}
template <MaybeConst<Closure> Value, typename Visit>
void fields_of(Value& closure, Visit& visit) {
  visit(closure.from, closure.to, closure.match, closure.verdict, closure.was_given);
}

/// The results of `make(i)` for each i in [0, count), in that order, made by all workers.
/// @param jobs threads at once in each process, see `Workers::shared`
template <typename Result, typename Make>
[[nodiscard]] std::vector<Result> made_by(const Workers& workers, std::size_t count, int jobs,
                                          const Make& make) {
  if (!workers.is_shared()) return results_of<Result>(count, jobs, make);
  std::vector<Result> results;
  results.reserve(count);
  for (const std::string& bytes :
       workers.shared(count, jobs, [&](std::size_t i) { return packed<Result>(make(i)); })) {
    results.push_back(unpacked<Result>(bytes));
  }
  return results;
}

}  // namespace roomatlas
