// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/self_consistency.hpp"

#include <array>
#include <cmath>

#include "consistency_figures.hpp"

namespace roomatlas {
namespace {

struct FigureFacts {
  const char* name;
  const char* unit;
  double typical;  ///< of a map with errors that one can see
};

/// The typical sizes weigh the figures in the sum: docs/evaluation.md, "Without truth".
constexpr std::array<FigureFacts, kConsistencyFigures> kFacts = {{
    {"overlap of rooms", "", 0.05},
    {"negative walls", "m", 0.02},
    {"door sides", "m", 0.2},
    {"doors again", "m", 0.3},
    {"corridor bend", "deg", 3.0},
    {"rays through walls", "", 0.2},
    {"hits in free space", "", 0.2},
    {"doubled walls", "m", 0.05},
}};

const FigureFacts& facts_of(ConsistencyFigure figure) {
  return kFacts.at(static_cast<std::size_t>(figure));
}

Box2 seen_box(const AsrEvidence& evidence, const Pose2& building_from_asr) {
  Box2 box;
  const Box2& seen = evidence.seen.box();
  if (seen.empty()) return box;
  for (const Point2& corner : {seen.min, seen.max, Point2(seen.min.x(), seen.max.y()),
                               Point2(seen.max.x(), seen.min.y())}) {
    box.extend(building_from_asr * corner);
  }
  return box;
}

Box2 solid_box(const AsrEvidence& evidence, const Pose2& building_from_asr) {
  Box2 box;
  for (const SurfaceSample& sample : evidence.surfaces) {
    box.extend(building_from_asr * sample.point);
  }
  for (const Segment2& wall : evidence.walls) {
    box.extend(building_from_asr * wall.a);
    box.extend(building_from_asr * wall.b);
  }
  return box;
}

PlacedAll placed_all(const std::vector<AsrEvidence>& evidence,
                     const std::map<AsrId, Pose2>& building_from_asr,
                     const std::map<AsrId, RoomId>& room_of_asr) {
  PlacedAll all;
  for (const AsrEvidence& asr : evidence) {
    const auto pose = building_from_asr.find(asr.asr);
    if (pose == building_from_asr.end()) continue;
    const auto room = room_of_asr.find(asr.asr);
    all.push_back({&asr, pose->second, room == room_of_asr.end() ? -asr.asr : room->second,
                   seen_box(asr, pose->second), solid_box(asr, pose->second)});
  }
  return all;
}

Verdict vote_of(const FigureVote& vote, const VerdictOptions& options) {
  const double change = vote.after - vote.before;
  const double clear = std::max(options.clear_share * std::max(vote.before, vote.after),
                                options.clear_fraction * facts_of(vote.figure).typical);
  if (std::abs(change) <= clear) return Verdict::undecided;
  return change < 0.0 ? Verdict::better : Verdict::worse;
}

/// Odometry joins two ASRs without error at the door they share, so figures that see small errors
/// there favour it. These do not.
bool is_fair_to_corrections(ConsistencyFigure figure) {
  return figure == ConsistencyFigure::doors_again || figure == ConsistencyFigure::corridor_bend ||
         figure == ConsistencyFigure::rays_through_walls ||
         figure == ConsistencyFigure::hits_in_free_space;
}

}  // namespace

bool near(const Box2& a, const Box2& b, double reach_m) {
  if (a.empty() || b.empty()) return false;
  return (a.min.array() <= b.max.array() + reach_m).all() &&
         (b.min.array() <= a.max.array() + reach_m).all();
}

NearAsrs::NearAsrs(const PlacedAll& all, Box2 PlacedEvidence::*box, double reach_m)
    : all_(all), box_(box), reach_m_(reach_m) {
  for (std::size_t i = 0; i < all.size(); ++i) index_.add(i, all[i].*box);
}

std::vector<const PlacedEvidence*> NearAsrs::near(const Box2& other) const {
  std::vector<const PlacedEvidence*> found;
  if (other.empty()) return found;
  const Point2 reach = Point2::Constant(reach_m_ + 0.01);  // more than rounding
  for (const std::size_t i : index_.near({other.min - reach, other.max + reach})) {
    if (roomatlas::near(other, all_[i].*box_, reach_m_)) found.push_back(&all_[i]);
  }
  return found;
}

const char* to_string(ConsistencyFigure figure) { return facts_of(figure).name; }
const char* unit_of(ConsistencyFigure figure) { return facts_of(figure).unit; }

const char* to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::better:
      return "better";
    case Verdict::worse:
      return "worse";
    case Verdict::undecided:
      break;
  }
  return "undecided";
}

SelfConsistency self_consistency(const std::vector<AsrEvidence>& evidence,
                                 const std::map<AsrId, Pose2>& building_from_asr,
                                 const std::map<AsrId, RoomId>& room_of_asr,
                                 const ConsistencyOptions& options) {
  const PlacedAll all = placed_all(evidence, building_from_asr, room_of_asr);
  const HitFigures hits = judge_hits(all, options);
  SelfConsistency result;
  result.figures = {room_overlap(all, options),
                    negative_walls(all, options),
                    door_sides(all),
                    doors_again(all, options),
                    corridor_bend(all),
                    rays_through_walls(all, options),
                    hits.in_free_space,
                    hits.doubled_walls};
  for (const ConsistencyValue& figure : result.figures) {
    if (std::isfinite(figure.value)) {
      result.inconsistency += figure.value / facts_of(figure.figure).typical;
    }
  }
  return result;
}

std::vector<VisitAgreement> visit_agreement(const std::vector<AsrEvidence>& evidence,
                                            const std::map<AsrId, Pose2>& building_from_asr,
                                            const ConsistencyOptions& options) {
  return judge_visits(placed_all(evidence, building_from_asr, {}), options);
}

ConsistencyComparison compare(const SelfConsistency& before, const SelfConsistency& after,
                              const VerdictOptions& options) {
  ConsistencyComparison comparison{before, after, {}, Verdict::undecided};
  double change = 0.0;
  int better = 0;
  int worse = 0;
  bool may_be_worse = !options.before_is_odometry;
  for (std::size_t i = 0; i < before.figures.size() && i < after.figures.size(); ++i) {
    FigureVote vote{before.figures[i].figure, before.figures[i].value, after.figures[i].value,
                    Verdict::undecided};
    if (!std::isfinite(vote.before) || !std::isfinite(vote.after)) continue;
    if (options.before_is_odometry && vote.figure == ConsistencyFigure::door_sides) continue;
    vote.vote = vote_of(vote, options);
    better += vote.vote == Verdict::better ? 1 : 0;
    worse += vote.vote == Verdict::worse ? 1 : 0;
    may_be_worse =
        may_be_worse || (vote.vote == Verdict::worse && is_fair_to_corrections(vote.figure));
    change += (vote.after - vote.before) / facts_of(vote.figure).typical;
    comparison.votes.push_back(vote);
  }
  if (change < 0.0 && better > worse) comparison.verdict = Verdict::better;
  if (change > 0.0 && worse > better && may_be_worse) comparison.verdict = Verdict::worse;
  return comparison;
}

}  // namespace roomatlas
