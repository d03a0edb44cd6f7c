// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/evaluate/alignment.hpp"
#include "roomatlas/evaluate/statistics.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace roomatlas {

/// What of an error pose counts; evo's list (there for SE(3); here the poses lie in the plane, so
/// a rotation is about the upright axis).
enum class PoseRelation {
  full,            ///< Frobenius norm of the error's matrix less the identity; no unit
  trans_part,      ///< metres
  rot_part,        ///< Frobenius norm of its rotation less the identity; no unit
  angle_deg,       ///< [0, 180]
  angle_rad,       ///< [0, pi]
  point_distance,  ///< APE: as `trans_part`. RPE: difference of the two distances; metres
  point_distance_error_ratio,  ///< RPE alone: that in percent of the true distance
};
[[nodiscard]] const char* to_string(PoseRelation relation);  ///< evo's name of the choice
[[nodiscard]] const char* title_of(PoseRelation relation);   ///< evo's words in a title
[[nodiscard]] const char* unit_of(PoseRelation relation);    ///< "m", "deg", "rad", "%" or ""

/// The error at each matched pose (APE) or pair of poses (RPE).
struct PoseErrors {
  std::vector<double> errors;  ///< of the chosen relation
  std::vector<std::size_t>
      places;                     ///< of each error in the matched poses; RPE: where the pair ends
  std::vector<std::size_t> from;  ///< RPE: where the pair begins
  Statistics statistics;
  Pose2 truth_from_estimate;        ///< the alignment that was used
  std::int64_t zero_distances = 0;  ///< pairs without a true distance, left out of a ratio
};

struct ApeOptions {
  PoseRelation relation = PoseRelation::trans_part;
  Alignment alignment = Alignment::umeyama;
  int poses_to_align = -1;  ///< from the start; negative: all
};

/// Absolute pose error of every matched pose, after alignment. Equal to evo's on the same poses.
/// @throws std::invalid_argument for `point_distance_error_ratio`
[[nodiscard]] PoseErrors ape(const MatchedPoses& matched, const ApeOptions& options);

enum class DeltaUnit { frames, metres, degrees, radians };
[[nodiscard]] const char* to_string(DeltaUnit unit);  ///< evo's letters: f, m, d, r

struct RpeOptions {
  PoseRelation relation = PoseRelation::trans_part;
  double delta = 1.0;                  ///< length of a pair; larger shows slower drift
  DeltaUnit unit = DeltaUnit::frames;  ///< metres: along the path. Angles: [0, 180] degrees
  bool all_pairs = false;              ///< every pose begins a pair, else end to end
  double relative_tolerance = 0.1;     ///< of all pairs by metres or angle: share of delta
  bool pairs_from_reference = false;   ///< path and angle are measured on the truth
};

/// Pairs of places (from, to) that are delta apart, chosen as evo chooses them:
/// - frames: 0, d, 2d ...; all pairs: every i with i + d;
/// - metres end to end: a place wherever delta has been driven since the one before, the first of
///   them beginning the first pair; all pairs: for each i the later place whose distance along
///   the path is nearest to delta, if within the tolerance;
/// - angles end to end: turns are summed until delta is reached; all pairs: every two poses whose
///   headings differ by delta within the tolerance (takes time with the square of the poses).
/// @throws UsageError when delta is negative, no whole number of frames, or beyond half a turn
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> delta_pairs(
    const std::vector<Pose2>& poses, const RpeOptions& options);

/// Relative pose error over pairs of matched poses. Equal to evo's on the same poses. No alignment
/// is needed: rigid motions drop out.
[[nodiscard]] PoseErrors rpe(const MatchedPoses& matched, const RpeOptions& options);

/// "RPE w.r.t. translation part (m) for delta = 1 (m) using all pairs".
[[nodiscard]] std::string title_of(const ApeOptions& options);
[[nodiscard]] std::string title_of(const RpeOptions& options);

}  // namespace roomatlas
