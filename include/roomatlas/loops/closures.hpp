// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "roomatlas/asr/asr.hpp"
#include "roomatlas/match/match_maps.hpp"
#include "roomatlas/match/room_localizer.hpp"

namespace roomatlas {

/// A measurement that the user adds. It is judged like any other.
struct GivenClosure {
  AsrId from = 0;
  AsrId to = 0;
  Pose2 from_from_to;
};

struct ClosureOptions {
  MatchMapsOptions match;
  double near_m = 3.0;             ///< paths that come this near may have seen the same walls ...
  double max_near_growth_m = 3.0;  ///< ... plus twice the uncertainty between them, at most this
  int max_candidates = 8;          ///< the nearest of these are tried when a room is new
  double window_sigmas = 4.0;      ///< how far is searched, of the uncertainty between two rooms,
  SearchWindow min_window{0.3, radians(2.0)};   ///< but no less ...
  SearchWindow max_window{8.0, radians(20.0)};  ///< ... and no more than this
  int min_agreeing = 80;                        ///< points on common walls; fewer prove nothing
  double min_agreement = 0.65;                  ///< of the points that can tell
  double again_near_m = 4.0;      ///< rooms this near are matched again once all are placed ...
  int again_max_candidates = 64;  ///< ... each with so many earlier ones, evenly over them: where
                                  ///< visits come back again and again all pairs would be a square,
  int again_min_agreeing = 60;    ///< ... and fewer points suffice then
  int rounds = 3;                 ///< of matching again, one at least
  int max_mends = 4;           ///< times that rooms which contradict each other are put where they
                               ///< fit in `max_window`, and all are matched again
  double mend_gain = 1.05;     ///< all scores together must grow so much by it,
  double mend_relief = 0.9;    ///< ... and the share of points that contradict must shrink so much:
                               ///< rooms alike that are laid on one another agree more, and no less
                               ///< contradicts
  double mend_seed = 0.0025;   ///< and those put elsewhere alone by so much of them: to be tried
  double robust_sigmas = 2.0;  ///< closures off by more lose weight (Cauchy)
  int without_best = 0;        ///< the best this many accepted closures are left out
  bool take_second = false;    ///< the second answer in the place of the first, where there is one
  std::vector<GivenClosure> given;                ///< tried beside those that are found
  std::vector<std::pair<AsrId, AsrId>> rejected;  ///< visits whose match is left out, either way
};

/// What is needed of an ASR to match it with others.
struct AsrShape {
  AsrId id = 0;
  LocalMap map{0.1};              ///< `shape_of` makes it, in cells of `LocalizeOptions::cell_m`
  std::vector<ScanPoint> points;  ///< the map's faces
  Polyline path;                  ///< thinned
};

/// @param asr with its readings; those of sonars are left out
/// @param localize how readings become the map, as while the robot was localized in it
[[nodiscard]] AsrShape shape_of(const Asr& asr, const LocalizeOptions& localize,
                                const MatchMapsOptions& match);

/// How near two paths come to each other, in metres; infinity where one is empty.
[[nodiscard]] double path_distance_m(const AsrShape& first, const AsrShape& second,
                                     const Pose2& first_from_second);

/// What became of a match that was tried.
enum class ClosureVerdict {
  accepted,
  too_little_in_common,  ///< fewer points on common walls than prove anything
  contradicted,          ///< too many points where the other saw free space
  left_out,              ///< good, but left out as asked
};

/// The verdict in words.
[[nodiscard]] const char* to_string(ClosureVerdict verdict);

/// A match of two ASRs, tried.
struct Closure {
  AsrId from = 0;
  AsrId to = 0;
  MapMatch match;
  ClosureVerdict verdict = ClosureVerdict::too_little_in_common;
  bool was_given = false;  ///< by the user, not found

  /// How much speaks for it: points on common walls, less those that contradict.
  [[nodiscard]] int score() const { return match.agreeing - match.contradicting; }
};

[[nodiscard]] ClosureVerdict judge(const MapMatch& match, int min_agreeing, double min_agreement);

}  // namespace roomatlas
