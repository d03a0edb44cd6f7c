// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/changes/lay_on.hpp"

#include <map>
#include <utility>
#include <vector>

#include "roomatlas/asr/load.hpp"

namespace roomatlas {
namespace {

/// The views of an ASR that are worth adding to a map.
template <typename Visit>
void for_each_view(const Asr& asr, const LocalizeOptions& localize, Visit visit) {
  std::optional<Pose2> last;
  for (std::size_t i = 0; i < asr.readings.size(); ++i) {
    const Pose2& pose = asr.path[i].asr_from_robot;
    if (!can_be_matched(asr.readings[i]) || (last && !is_new_view(*last, pose, localize))) continue;
    last = pose;
    visit(scan_of(asr.readings[i], localize.scan), pose);
  }
}

/// Adds all of a mission to a map, and hands on the points of each visit, in its own frame.
template <typename Visit>
LocalMap map_of(const AssembledMission& mission, const LayOnOptions& options,
                const Progress& progress, Visit visit) {
  LocalMap map(options.localize.cell_m);
  const std::vector<AsrId> ids = mission.source->ids();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    report(progress, "lay on each other", share_of(i, ids.size()));
    const Asr asr = load_with_readings(*mission.source, ids[i]);
    const Pose2& placed = mission.placement.at(asr.id);
    LocalMap own(options.localize.cell_m);
    for_each_view(asr, options.localize, [&](const Scan& scan, const Pose2& asr_from_robot) {
      map.add(scan, placed * asr_from_robot);
      own.add(scan, asr_from_robot);
    });
    visit(asr.id, points_of(own, options.match));
  }
  return map;
}

/// Where a visit lies in the old map: where the whole put it, or near there where it fits clearly
/// better. A little better may be a cupboard that was pushed onto the wall behind it. Nothing where
/// it contradicts the old map wherever it is laid.
std::optional<Pose2> settled(const SearchableMap& old_map, const std::vector<ScanPoint>& points,
                             const Pose2& old_from_asr, const LayOnOptions& options) {
  const MapMatch there = old_map.find(points, old_from_asr, {});
  const MapMatch near = old_map.find(points, old_from_asr, options.settle);
  if (near.agreeing + near.contradicting < options.settle_min_telling) return old_from_asr;
  if (near.agreement() >= options.settle_min_agreement &&
      near.agreement() >= there.agreement() + options.settle_gain) {
    return near.first_from_second;
  }
  if (there.agreement() < options.stay_min_agreement) return std::nullopt;
  return there.first_from_second;
}

/// The match near a guess for which most speaks.
MapMatch best_match(const SearchableMap& old_map, const std::vector<ScanPoint>& points,
                    const std::vector<Pose2>& guesses, const LayOnOptions& options) {
  MapMatch best;
  for (const Pose2& guess : guesses) {
    const MapMatch match = old_map.find(points, guess, options.around);
    const bool is_better =
        match.agreeing - match.contradicting > best.agreeing - best.contradicting;
    if (is_better) best = match;
  }
  return best;
}

}  // namespace

std::vector<Pose2> quarter_turns() {
  std::vector<Pose2> guesses;
  for (const double turn_deg : {0.0, 90.0, -90.0, -180.0}) {
    guesses.push_back({0.0, 0.0, radians(turn_deg)});
  }
  return guesses;
}

std::optional<LaidOn> lay_on(const AssembledMission& before, const AssembledMission& after,
                             const std::vector<Pose2>& guesses_old_from_new,
                             const LayOnOptions& options, const Progress& progress) {
  const LocalMap old_map = map_of(before, options, progress, [](AsrId, const auto&) {});
  std::map<AsrId, std::vector<ScanPoint>> points;
  const LocalMap new_map =
      map_of(after, options, progress,
             [&](AsrId id, std::vector<ScanPoint> of_visit) { points[id] = std::move(of_visit); });
  if (old_map.empty() || new_map.empty()) {  // sonars: nothing to match by
    if (guesses_old_from_new.size() != 1) return std::nullopt;
    LaidOn laid{guesses_old_from_new.front(), {}, 0.0};
    for (const auto& [id, pose] : after.placement) laid.placement[id] = laid.old_from_new * pose;
    return laid;
  }
  const SearchableMap searched(old_map, options.match);
  const MapMatch match =
      best_match(searched, points_of(new_map, options.match), guesses_old_from_new, options);
  if (match.agreeing < options.min_agreeing || match.agreement() < options.min_agreement) {
    return std::nullopt;
  }
  LaidOn laid{match.first_from_second, {}, match.agreement()};
  for (const auto& [id, of_visit] : points) {
    const std::optional<Pose2> place =
        settled(searched, of_visit, laid.old_from_new * after.placement.at(id), options);
    if (place) laid.placement[id] = *place;
  }
  return laid;
}

}  // namespace roomatlas
