// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/graph/recognise.hpp"

#include "roomatlas/core/place_index.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace roomatlas {
namespace {

/// The robot going through a doorway, placed in the building.
struct Crossing {
  AsrId from = 0;
  AsrId to = 0;
  Pose2 building_from_pivot;  ///< theta is the direction of travel
  double width_m = 0.0;
  double at_m = 0.0;  ///< along the mission's path
};

std::vector<Crossing> crossings_of(const std::vector<Asr>& asrs, const Placement& placement) {
  std::vector<Crossing> crossings;
  double driven_m = 0.0;
  for (const Asr& asr : asrs) {
    driven_m += path_length_m(asr);
    for (const Exit& exit : asr.exits) {
      if (exit.is_entry || exit.kind != PassageKind::doorway || !exit.neighbor) continue;
      if (!placement.contains(*exit.neighbor)) continue;
      // the pivot is the origin of the ASR behind it
      crossings.push_back(
          {asr.id, *exit.neighbor, placement.at(*exit.neighbor), exit.width_m, driven_m});
    }
  }
  return crossings;
}

/// How far apart two crossings are if they may be of the same doorway, else nothing.
std::optional<double> distance_if_same(const Crossing& earlier, const Crossing& later,
                                       const RecogniseOptions& options) {
  const double gate_m = std::min(
      options.max_gate_m, options.gate_m + options.gate_growth * (later.at_m - earlier.at_m));
  const double apart_m =
      (earlier.building_from_pivot.position() - later.building_from_pivot.position()).norm();
  const double turn = std::abs(
      wrap_angle(later.building_from_pivot.theta_rad - earlier.building_from_pivot.theta_rad));
  const double skew = std::min(turn, kPi - turn);
  if (apart_m > gate_m || skew > radians(options.max_turn_deg) ||
      std::abs(earlier.width_m - later.width_m) > options.max_width_difference_m) {
    return std::nullopt;
  }
  return apart_m;
}

}  // namespace

std::vector<PassageEdge> recognise_doorways(const std::vector<Asr>& asrs,
                                            const Placement& placement,
                                            const RecogniseOptions& options) {
  const std::vector<Crossing> crossings = crossings_of(asrs, placement);
  std::vector<PassageEdge> found;
  PlaceIndex crossed;  // those before `later`
  for (std::size_t later = 0; later < crossings.size(); ++later) {
    std::optional<std::size_t> best;
    double best_m = 0.0;
    const Point2 place = crossings[later].building_from_pivot.position();
    for (const std::size_t earlier : crossed.near(box_around(place, options.max_gate_m))) {
      const auto apart_m = distance_if_same(crossings[earlier], crossings[later], options);
      if (!apart_m || (best && *apart_m >= best_m)) continue;
      best = earlier;
      best_m = *apart_m;
    }
    crossed.add(later, box_around(place, 0.0));
    if (!best) continue;
    const double turn = wrap_angle(crossings[later].building_from_pivot.theta_rad -
                                   crossings[*best].building_from_pivot.theta_rad);
    const bool is_same_way = std::abs(turn) < kPi / 2.0;
    found.push_back({crossings[*best].to,
                     crossings[later].to,
                     {0.0, 0.0, is_same_way ? 0.0 : wrap_angle(kPi)},
                     PassageKind::doorway,
                     EdgeSource::recognised,
                     0.0,
                     {}});
  }
  return found;
}

}  // namespace roomatlas
