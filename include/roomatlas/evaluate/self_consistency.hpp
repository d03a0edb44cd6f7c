// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/evaluate/asr_evidence.hpp"

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace roomatlas {

/// How well a placement of ASRs agrees with itself; each figure is 0 in a perfect map and grows
/// with its errors.
enum class ConsistencyFigure {
  /// Share of the building's area that more than one room's outlines cover. Shows rooms pushed into
  /// each other. Cannot show rooms pulled apart, nor two visits of one room that disagree.
  room_overlap,
  /// Mean depth in metres by which the wall of one room lies behind that of its neighbour where
  /// the two back onto each other within 0.6 m, over all samples of walls (0 where a wall has
  /// thickness, or no neighbour). Shows neighbours pushed into each other. Cannot show walls that
  /// came out too thick.
  negative_walls,
  /// Mean distance in metres between the jambs of a driven doorway as its two ASRs place them.
  /// Shows what a correction tore apart. Odometry scores at its least whatever it did, because it
  /// placed each ASR by that very doorway: no vote when odometry is compared with a correction.
  door_sides,
  /// Mean distance in metres from a doorway to the nearest doorway of another visit that leads the
  /// same way, within 1 m, of those that are not the two sides of one passage. Shows doors that
  /// were crossed again and did not come to lie on each other. Cannot show doors crossed once, nor
  /// doors more than 1 m off.
  doors_again,
  /// Mean angle in degrees between the walls of two pieces of one corridor or hall, modulo a right
  /// angle. Shows corridors that bend. Cannot show a corridor that is truly bent (it scores its
  /// true
  /// bend before and after), nor a turn that all pieces share. A correction by wall directions
  /// makes
  /// this small by itself.
  corridor_bend,
  /// Share of the rays that go on for more than 0.3 m behind a wall that another ASR has mapped,
  /// of those that come that near such a wall. Glass, doors that were moved and furniture count
  /// too,
  /// before and after alike.
  rays_through_walls,
  /// Share of the hits that lie in what another ASR saw to be free, more than 0.3 m from anything
  /// it
  /// hit, of all hits in space that another ASR saw. The same can be said of people and doors that
  /// moved.
  hits_in_free_space,
  /// Mean distance in metres from a hit to the straight surface that another ASR hit near it,
  /// across
  /// that surface; 0.3 m for a hit in free space. Shows doubled and blurred walls, from a degree
  /// on.
  /// Cannot show places that only one ASR saw.
  doubled_walls,
};
constexpr int kConsistencyFigures = 8;  ///< how many there are

[[nodiscard]] const char* to_string(ConsistencyFigure figure);
/// "m", "deg" or "" for a share.
[[nodiscard]] const char* unit_of(ConsistencyFigure figure);

struct ConsistencyValue {
  ConsistencyFigure figure = ConsistencyFigure::room_overlap;
  double value = std::numeric_limits<double>::quiet_NaN();  ///< NaN: nothing to measure it on
  double measured = 0.0;  ///< on how much: samples, doors or square metres
};

struct SelfConsistency {
  std::vector<ConsistencyValue> figures;  ///< one of each, in the order of the enum
  /// Sum over the figures of each value over what a map with errors that one can see has (see
  /// docs/evaluation.md): one number that grows with the errors. Only compare it between
  /// placements of the same ASRs.
  double inconsistency = 0.0;
};

struct ConsistencyOptions {
  EvidenceOptions evidence;
  double deep_m = 0.3;        ///< a contradiction is at least this deep; less counts noise
  double wall_reach_m = 0.6;  ///< thicker walls are not compared
  double door_reach_m = 1.0;  ///< farther doorways are other doors
  int min_free_rays = 2;      ///< sampled rays that make a cell free; 1 believes a lone reading
  int jobs = 1;               ///< threads at once, see `for_each_index`; no result hangs on it
};

/// Judges a placement from readings and geometry alone: no truth, and nothing of the solver's cost.
/// Not guaranteed: a map that is wrong in a way that no two ASRs can notice (an open chain bent as
/// a whole, a building scaled) scores well.
/// @param evidence of all ASRs, see `evidence_of`
/// @param building_from_asr the placement to judge; ASRs without a pose are left out
/// @param room_of_asr which ASRs are one room; ASRs without a room are rooms of their own
[[nodiscard]] SelfConsistency self_consistency(const std::vector<AsrEvidence>& evidence,
                                               const std::map<AsrId, Pose2>& building_from_asr,
                                               const std::map<AsrId, RoomId>& room_of_asr,
                                               const ConsistencyOptions& options);

/// What the other visits say of what one visit hit.
struct VisitAgreement {
  AsrId asr = 0;
  std::int64_t hits = 0;   ///< that were asked about
  std::int64_t known = 0;  ///< of those, in space that another visit saw

  // Of all pairs of a hit and another visit that saw its place:
  std::int64_t seen = 0;           ///< how many there are
  std::int64_t in_free_space = 0;  ///< far from anything that the other hit
  std::int64_t compared = 0;       ///< near a straight surface, or in free space
  double apart_m = 0.0;            ///< of those, added up: how far from that surface
};

/// The agreement of each visit with the others, in the order of the evidence; see
/// `hits_in_free_space` and `doubled_walls`, which are its sums. ASRs without a pose are left out.
[[nodiscard]] std::vector<VisitAgreement> visit_agreement(
    const std::vector<AsrEvidence>& evidence, const std::map<AsrId, Pose2>& building_from_asr,
    const ConsistencyOptions& options);

enum class Verdict { undecided, better, worse };
[[nodiscard]] const char* to_string(Verdict verdict);

/// What one figure says of "after" against "before".
struct FigureVote {
  ConsistencyFigure figure = ConsistencyFigure::room_overlap;
  double before = 0.0;
  double after = 0.0;
  Verdict vote = Verdict::undecided;
};

struct ConsistencyComparison {
  SelfConsistency before;
  SelfConsistency after;
  std::vector<FigureVote> votes;  ///< of the figures that were measured on both and may vote
  Verdict verdict = Verdict::undecided;
};

struct VerdictOptions {
  double clear_share = 0.1;      ///< a figure votes when it changes by more than this share ...
  double clear_fraction = 0.02;  ///< ... and by this fraction of its typical size
  /// `door_sides` then has no vote, and "worse" needs the vote of a figure that does not depend on
  /// the last centimetres at a door: doors again, corridor bend, rays through walls, hits in free
  /// space.
  bool before_is_odometry = true;
};

/// Compares two placements of the same ASRs. Better or worse is decided by the sum of changes of
/// all figures that vote, each over its typical size, and needs more figures for it than against
/// it; else it is undecided.
[[nodiscard]] ConsistencyComparison compare(const SelfConsistency& before,
                                            const SelfConsistency& after,
                                            const VerdictOptions& options);

}  // namespace roomatlas
