// SPDX-License-Identifier: GPL-3.0-or-later
// Doorways and corridors: what the passages say.
#include <algorithm>
#include <cmath>
#include <map>

#include "consistency_figures.hpp"

namespace roomatlas {
namespace {

constexpr double kSameDirection = 0.7;  ///< cosine between directions of one doorway

std::map<AsrId, const PlacedEvidence*> by_asr(const PlacedAll& all) {
  std::map<AsrId, const PlacedEvidence*> found;
  for (const PlacedEvidence& placed : all) found[placed.evidence->asr] = &placed;
  return found;
}

/// One side of a doorway or passage, placed.
struct PlacedExit {
  const PlacedEvidence* asr = nullptr;
  const Exit* exit = nullptr;
  Point2 middle = Point2::Zero();
  Point2 along = Point2::UnitX();  ///< out of the ASR
};

std::vector<PlacedExit> doorways_of(const PlacedAll& all) {
  std::vector<PlacedExit> doorways;
  for (const PlacedEvidence& placed : all) {
    for (const Exit& exit : placed.evidence->exits) {
      if (exit.kind != PassageKind::doorway) continue;
      const Pose2 pivot = placed.building_from_asr * exit.frame_from_pivot;
      doorways.push_back({&placed, &exit, pivot.position(), direction(pivot.theta_rad)});
    }
  }
  return doorways;
}

/// The entry of `to` that leads back to `from`.
const Exit* entry_from(const AsrEvidence& to, AsrId from) {
  for (const Exit& exit : to.exits) {
    if (exit.is_entry && exit.neighbor == from) return &exit;
  }
  return nullptr;
}

/// Calls `visit` with the exit of each passage driven through and the entry on its other side.
template <typename Visit>
void for_each_passage(const PlacedAll& all, PassageKind kind, Visit visit) {
  const auto placed_of = by_asr(all);
  for (const PlacedEvidence& from : all) {
    for (const Exit& exit : from.evidence->exits) {
      if (exit.is_entry || exit.kind != kind || !exit.neighbor) continue;
      const auto to = placed_of.find(*exit.neighbor);
      if (to == placed_of.end()) continue;
      const Exit* entry = entry_from(*to->second->evidence, from.evidence->asr);
      if (entry != nullptr) visit(from, exit, *to->second, *entry);
    }
  }
}

/// The two sides of one passage, or two exits of one ASR.
bool same_passage(const PlacedExit& a, const PlacedExit& b) {
  return a.asr == b.asr || a.exit->neighbor == b.asr->evidence->asr ||
         b.exit->neighbor == a.asr->evidence->asr;
}

}  // namespace

ConsistencyValue door_sides(const PlacedAll& all) {
  double sum_m = 0.0;
  std::int64_t doors = 0;
  for_each_passage(all, PassageKind::doorway,
                   [&](const PlacedEvidence& from, const Exit& exit, const PlacedEvidence& to,
                       const Exit& entry) {
                     const Segment2 out = transformed(from.building_from_asr, exit.jambs);
                     const Segment2 in = transformed(to.building_from_asr, entry.jambs);
                     sum_m += ((out.a - in.b).norm() + (out.b - in.a).norm()) / 2.0;
                     ++doors;
                   });
  ConsistencyValue result{ConsistencyFigure::door_sides};
  result.measured = static_cast<double>(doors);
  if (doors > 0) result.value = sum_m / result.measured;
  return result;
}

ConsistencyValue doors_again(const PlacedAll& all, const ConsistencyOptions& options) {
  const std::vector<PlacedExit> doorways = doorways_of(all);
  PlaceIndex index;
  for (std::size_t i = 0; i < doorways.size(); ++i) {
    index.add(i, box_around(doorways[i].middle, 0.0));
  }
  double sum_m = 0.0;
  std::int64_t met = 0;
  for (const PlacedExit& a : doorways) {
    double nearest_m = options.door_reach_m;
    bool found = false;
    for (const std::size_t i : index.near(box_around(a.middle, options.door_reach_m))) {
      const PlacedExit& b = doorways[i];
      if (same_passage(a, b) || std::abs(a.along.dot(b.along)) < kSameDirection) continue;
      const double apart_m = (a.middle - b.middle).norm();
      if (apart_m >= nearest_m) continue;
      nearest_m = apart_m;
      found = true;
    }
    if (!found) continue;
    sum_m += nearest_m;
    ++met;
  }
  ConsistencyValue result{ConsistencyFigure::doors_again};
  result.measured = static_cast<double>(met);
  if (met > 0) result.value = sum_m / result.measured;
  return result;
}

ConsistencyValue corridor_bend(const PlacedAll& all) {
  double sum_deg = 0.0;
  std::int64_t pairs = 0;
  for_each_passage(
      all, PassageKind::open_passage,
      [&](const PlacedEvidence& from, const Exit&, const PlacedEvidence& to, const Exit&) {
        const auto a = from.evidence->wall_direction_rad;
        const auto b = to.evidence->wall_direction_rad;
        if (!a || !b) return;
        const double apart_rad =
            *b + to.building_from_asr.theta_rad - *a - from.building_from_asr.theta_rad;
        sum_deg += degrees(std::abs(wrap_angle(4.0 * apart_rad)) / 4.0);
        ++pairs;
      });
  ConsistencyValue result{ConsistencyFigure::corridor_bend};
  result.measured = static_cast<double>(pairs);
  if (pairs > 0) result.value = sum_deg / result.measured;
  return result;
}

}  // namespace roomatlas
