// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/join/place_mission.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "packed.hpp"
#include "roomatlas/core/geometry.hpp"

namespace roomatlas {
namespace {

/// Consecutive visits, sketched in the mission's frame.
struct Piece {
  std::vector<const AsrShape*> shapes;
  FloorSketch sketch;
  Point2 middle = Point2::Zero();
};

Piece finished(Piece piece, const MissionMap& mission) {
  piece.sketch = sketch_of(piece.shapes, mission.mission_from_asr);
  for (const Point2& at : piece.sketch.path) piece.middle += at;
  piece.middle /= std::max<double>(1.0, static_cast<double>(piece.sketch.path.size()));
  return piece;
}

std::vector<Piece> pieces_of(const MissionMap& mission, const PlaceMissionOptions& options) {
  std::vector<Piece> pieces;
  Piece piece;
  double way_m = 0.0;
  std::size_t walls = 0;
  for (const AsrShape& shape : mission.shapes) {
    piece.shapes.push_back(&shape);
    way_m += length(shape.path);
    walls += shape.points.size();
    const bool is_enough =
        way_m >= options.piece_way_m && walls >= static_cast<std::size_t>(options.min_piece_walls);
    if (!is_enough) continue;
    pieces.push_back(finished(std::move(piece), mission));
    piece = {};
    way_m = 0.0;
    walls = 0;
  }
  if (!piece.shapes.empty()) pieces.push_back(finished(std::move(piece), mission));
  return pieces;
}

/// A place that a piece votes for.
struct Vote {
  std::size_t piece = 0;
  Pose2 building_from_mission;
  double score = 0.0;
  double support = 0.0;  ///< of all pieces that vote alike
};

double fitting_share(const MissionPlace& place) {
  return place.pieces.empty()
             ? 0.0
             : static_cast<double>(place.fitting()) / static_cast<double>(place.pieces.size());
}

double next_score(const std::vector<MissionPlace>& places) {
  return places.size() < 2 ? 0.0 : places[1].score;
}

class MissionPlacer {
 public:
  MissionPlacer(const MissionMap& mission, const BuildingIndex& building,
                const PlaceMissionOptions& options, const Progress& progress,
                const Workers& workers)
      : building_(building),
        options_(options),
        progress_(progress),
        workers_(workers),
        pieces_(pieces_of(mission, options)) {}

  MissionSearch run() {
    std::vector<std::size_t> first;
    std::vector<std::size_t> rest;
    const std::size_t stride = std::max<std::size_t>(
        1, pieces_.size() / static_cast<std::size_t>(std::max(1, options_.searched_pieces)));
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      (i % stride == stride / 2 ? first : rest).push_back(i);
    }
    MissionSearch search;
    for (const auto& some : {first, rest}) {
      if (some.empty()) continue;
      vote(some);
      search = followed();
      if (search.verdict == PlaceVerdict::placed) break;
    }
    return search;
  }

 private:
  void vote(const std::vector<std::size_t>& some) {
    constexpr int kOneByOne = 1;  // each uses all threads itself
    using Places = std::vector<PlaceHypothesis>;
    const std::vector<Places> found =
        made_by<Places>(workers_, some.size(), kOneByOne, [&](std::size_t k) {
          report(progress_, "look for places", share_of(searched_++, pieces_.size()));
          Places places = building_.find(pieces_[some[k]].sketch, workers_.jobs());
          places.resize(std::min(places.size(), static_cast<std::size_t>(options_.places_a_piece)));
          return places;
        });
    for (std::size_t k = 0; k < some.size(); ++k) {
      for (const PlaceHypothesis& place : found[k]) {
        if (place.score <= 0.0) continue;
        votes_.push_back({some[k], place.building_from_query, place.score, 0.0});
      }
    }
  }

  /// Whether two places lay a piece at about the same spot.
  [[nodiscard]] bool are_alike(const Pose2& one, const Pose2& other, const Point2& at) const {
    return (one * at - other * at).norm() <= options_.alike_m &&
           std::abs(degrees(wrap_angle(one.theta_rad - other.theta_rad))) <= options_.alike_deg;
  }

  /// The votes with the support of all that are alike, one of each kind, the best first.
  [[nodiscard]] std::vector<Vote> elected() const {
    std::vector<Vote> votes = votes_;
    for (Vote& vote : votes) {
      std::vector<double> best(pieces_.size(), 0.0);
      for (const Vote& other : votes) {
        if (!are_alike(vote.building_from_mission, other.building_from_mission,
                       pieces_[other.piece].middle)) {
          continue;
        }
        best[other.piece] = std::max(best[other.piece], other.score);
      }
      vote.support = std::accumulate(best.begin(), best.end(), 0.0);
    }
    std::stable_sort(votes.begin(), votes.end(),
                     [](const Vote& a, const Vote& b) { return a.support > b.support; });
    std::vector<Vote> kinds;
    for (const Vote& vote : votes) {
      if (kinds.size() >= static_cast<std::size_t>(options_.tried)) break;
      const bool is_known = std::any_of(kinds.begin(), kinds.end(), [&](const Vote& kind) {
        return are_alike(kind.building_from_mission, vote.building_from_mission,
                         pieces_[vote.piece].middle);
      });
      if (!is_known) kinds.push_back(vote);
    }
    return kinds;
  }

  [[nodiscard]] MissionSearch followed() const {
    const std::vector<Vote> kinds = elected();
    MissionSearch search;
    search.places = made_by<MissionPlace>(workers_, kinds.size(), workers_.jobs(),
                                          [&](std::size_t i) { return follow(kinds[i]); });
    std::stable_sort(
        search.places.begin(), search.places.end(),
        [](const MissionPlace& a, const MissionPlace& b) { return a.score > b.score; });
    search.verdict = judged(search.places);
    return search;
  }

  /// From the piece that voted to both ends, each piece from where the one before lies.
  [[nodiscard]] MissionPlace follow(const Vote& vote) const {
    MissionPlace place;
    place.pieces.resize(pieces_.size());
    Pose2 guess = vote.building_from_mission;
    for (std::size_t i = vote.piece; i < pieces_.size(); ++i) {
      place.pieces[i] = followed_to(i, vote, guess);
    }
    place.building_from_mission = place.pieces[vote.piece].place.building_from_query;
    guess = place.building_from_mission;
    for (std::size_t i = vote.piece; i-- > 0;) place.pieces[i] = followed_to(i, vote, guess);
    for (const PlacedPiece& piece : place.pieces) {
      place.score += piece.is_inside ? piece.place.score : std::min(0.0, piece.place.score);
      if (!piece.is_inside) continue;
      place.agreeing += piece.place.agreeing;
      place.contradicting += piece.place.contradicting + piece.place.missing;
    }
    return place;
  }

  /// From where the piece before lies, or else, since the mission may have bent where the building
  /// is not known, from where the piece itself votes.
  [[nodiscard]] PlacedPiece followed_to(std::size_t piece, const Vote& vote, Pose2& guess) const {
    PlacedPiece result = placed(pieces_[piece], guess);
    if (result.fits) return result;
    const Vote* own = vote_alike(piece, vote);
    if (own == nullptr) return result;
    Pose2 own_guess = own->building_from_mission;
    PlacedPiece other = placed(pieces_[piece], own_guess);
    if (!other.fits) return result;
    guess = own_guess;
    return other;
  }

  /// The best of a piece's own votes for the same place; null where there is none.
  [[nodiscard]] const Vote* vote_alike(std::size_t piece, const Vote& vote) const {
    const Vote* best = nullptr;
    for (const Vote& other : votes_) {
      const bool is_alike =
          other.piece == piece &&
          are_alike(vote.building_from_mission, other.building_from_mission, pieces_[piece].middle);
      if (is_alike && (best == nullptr || other.score > best->score)) best = &other;
    }
    return best;
  }

  [[nodiscard]] PlacedPiece placed(const Piece& piece, Pose2& guess) const {
    PlacedPiece result;
    for (const AsrShape* shape : piece.shapes) result.visits.push_back(shape->id);
    result.place = building_.fit(piece.sketch, guess);
    const Pose2& found = result.place.building_from_query;
    result.fits =
        result.place.agreeing >= options_.min_agreeing &&
        result.place.agreement() >= options_.min_piece_agreement &&
        (found * piece.middle - guess * piece.middle).norm() <= options_.max_bend_m &&
        std::abs(degrees(wrap_angle(found.theta_rad - guess.theta_rad))) <= options_.max_bend_deg;
    if (result.fits) {
      guess = found;
    } else {
      result.place = building_.at(piece.sketch, guess);
    }
    result.is_inside = building_.share_on_floor(piece.sketch, result.place.building_from_query) >=
                       options_.min_path_on_floor;
    result.fits = result.fits && result.is_inside;
    return result;
  }

  [[nodiscard]] bool is_refurnished(const std::vector<MissionPlace>& places) const {
    return places[0].score >= options_.refurnished.min_score &&
           may_be_refurnished(places, options_);
  }

  [[nodiscard]] PlaceVerdict judged(const std::vector<MissionPlace>& places) const {
    if (places.empty() || places[0].score < options_.min_score ||
        (places[0].agreement() < options_.min_agreement && !is_refurnished(places))) {
      return PlaceVerdict::nothing_in_common;
    }
    const double score = places[0].score;
    const double next = next_score(places);
    const double margin = options_.min_margin + options_.margin_sigmas * std::sqrt(score);
    const bool is_alone = score >= options_.sure_score ||
                          fitting_share(places[0]) >= options_.sure_fitting ||
                          next <= options_.max_next * score;
    const bool is_clear = places.size() < 2 || (score - next >= margin && is_alone);
    return is_clear ? PlaceVerdict::placed : PlaceVerdict::ambiguous;
  }

  const BuildingIndex& building_;
  const PlaceMissionOptions& options_;
  const Progress& progress_;
  const Workers& workers_;
  std::size_t searched_ = 0;  ///< pieces
  std::vector<Piece> pieces_;
  std::vector<Vote> votes_;
};

}  // namespace

std::size_t MissionPlace::fitting() const {
  return static_cast<std::size_t>(std::count_if(
      pieces.begin(), pieces.end(), [](const PlacedPiece& piece) { return piece.fits; }));
}

std::map<AsrId, Pose2> MissionPlace::building_from_mission_by_visit() const {
  std::map<AsrId, Pose2> poses;
  for (const PlacedPiece& piece : pieces) {
    for (const AsrId id : piece.visits) poses[id] = piece.place.building_from_query;
  }
  return poses;
}

bool may_be_refurnished(const std::vector<MissionPlace>& places,
                        const PlaceMissionOptions& options) {
  if (places.empty() || places[0].score < options.min_score) return false;
  const auto& least = options.refurnished;
  return places[0].agreement() >= least.min_agreement &&
         fitting_share(places[0]) >= least.min_fitting &&
         next_score(places) <= least.max_next * places[0].score;
}

const char* to_string(PlaceVerdict verdict) {
  switch (verdict) {
    case PlaceVerdict::placed:
      return "placed";
    case PlaceVerdict::nothing_in_common:
      return "nothing in common";
    case PlaceVerdict::ambiguous:
      return "ambiguous";
  }
  return "unknown";
}

MissionSearch place_mission(const MissionMap& mission, const BuildingIndex& building,
                            const PlaceMissionOptions& options, const Progress& progress,
                            const Workers& workers) {
  return MissionPlacer(mission, building, options, progress, workers).run();
}

FloorSketch sketch_of(const MissionMap& mission) {
  std::vector<const AsrShape*> all;
  for (const AsrShape& shape : mission.shapes) all.push_back(&shape);
  return sketch_of(all, mission.mission_from_asr);
}

}  // namespace roomatlas
