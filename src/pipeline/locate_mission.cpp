// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/pipeline/locate_mission.hpp"

#include <algorithm>
#include <cmath>

#include "roomatlas/asr/with_paths.hpp"
#include "roomatlas/core/geometry.hpp"
#include "roomatlas/pipeline/mission_map.hpp"
#include "strategies.hpp"

namespace roomatlas {
namespace {

/// The readings of an asked mission where its own correction puts them.
struct Asked {
  CorrectedMission corrected;
  Placement placement;
};

Asked corrected(const AsrSource& asked, const RobotFootprint& footprint, const Options& options,
                const Progress& progress) {
  Asked result;
  result.corrected =
      correct_mission(mission_kind(asked, options.assemble), asked, footprint, options, progress);
  result.placement = placement_of(result.corrected.correction);
  return result;
}

/// The likeliest place has the probability that was learnt. What is left is shared among the others
/// and a place that nobody knows by their scores; no other gets more than the likeliest, and what
/// that leaves over speaks for none of them.
void set_odds(double first_is_right, double nowhere_score, LocatedMission& located) {
  if (located.places.empty()) return;
  double best = nowhere_score;
  for (std::size_t i = 1; i < located.places.size(); ++i) {
    best = std::max(best, located.places[i].score);
  }
  double sum = std::exp(nowhere_score - best);
  located.odds.assign(1, first_is_right);
  for (std::size_t i = 1; i < located.places.size(); ++i) {
    located.odds.push_back(std::exp(located.places[i].score - best));
    sum += located.odds.back();
  }
  located.nowhere_odds = 1.0 - first_is_right;
  for (std::size_t i = 1; i < located.odds.size(); ++i) {
    located.odds[i] = std::min(first_is_right, located.odds[i] / sum * (1.0 - first_is_right));
    located.nowhere_odds -= located.odds[i];
  }
  located.nowhere_odds = std::max(0.0, located.nowhere_odds);
}

PlaceVerdict verdict_on(double first_is_right, PlaceVerdict by_walls) {
  if (first_is_right >= kSurePlace) return PlaceVerdict::placed;
  const bool is_somewhere = by_walls != PlaceVerdict::nothing_in_common;
  return is_somewhere ? PlaceVerdict::ambiguous : PlaceVerdict::nothing_in_common;
}

double way_of(const MissionMap& mission) {
  double way_m = 0.0;
  for (const AsrShape& shape : mission.shapes) way_m += length(shape.path);
  return way_m;
}

Trajectory trajectory_at(const MissionPlace& place, const AsrSource& source,
                         const Placement& placement) {
  Trajectory trajectory;
  for (const auto& [id, pose] : place.building_from_mission_by_visit()) {
    const Pose2 building_from_asr = pose * placement.at(id);
    for (const PathSample& sample : source.get(id, AsrDetail::path).path) {
      trajectory.push_back({sample.timestamp_s, building_from_asr * sample.asr_from_robot});
    }
  }
  return trajectory;
}

}  // namespace

PlaceMissionOptions locating_options(double way_m) {
  PlaceMissionOptions options;
  options.min_agreement = 0.85;  // other buildings reach 0.84 over 5 m of corridor
  options.refurnished.min_agreement = options.min_agreement;
  options.min_score = 15.0;
  options.sure_score = options.min_score;  // a few metres of path have no more
  options.min_margin = 5.0;  // rooms alike differ by up to 3.2, by errors of their maps
  options.margin_sigmas = 0.0;
  // What walls of a few metres put at the hundredth place rays may put first; of a longer path
  // walls know better, and each place costs more.
  const double share = options.piece_way_m / std::max(way_m, options.piece_way_m);
  options.tried = std::max(12, static_cast<int>(120.0 * share));
  options.places_a_piece = std::max(20, options.tried);
  return options;
}

MissionLocator::MissionLocator(const MissionMap& known, const Options& options)
    : options_(options), index_(sketch_of(known), LocateOptions{}) {}

LocatedMission MissionLocator::locate(const AsrSource& asked, const RobotFootprint& footprint,
                                      const Progress& progress) const {
  const Asked mission = corrected(asked, footprint, options_, progress);
  report(progress, "locate", -1.0);
  const AsrSource& recorded = mission.corrected.recorded_again
                                  ? static_cast<const AsrSource&>(*mission.corrected.recorded_again)
                                  : asked;
  const WithPaths source(recorded, mission.corrected.paths);
  const MissionMap query = mission_map_of(source, mission.placement, options_);
  const PlaceMissionOptions placing = locating_options(way_of(query));
  MissionSearch search = place_mission(query, index_, placing, progress, options_.jobs);
  JudgedPlaces judged =
      judge_places(std::move(search.places), asked_visits(query), index_.seen(), query.sensor, {});
  LocatedMission located;
  located.verdict = verdict_on(judged.first_is_right, search.verdict);
  located.sensor = query.sensor;
  located.places = std::move(judged.places);
  located.figures = std::move(judged.figures);
  set_odds(judged.first_is_right, placing.min_score, located);
  if (!located.places.empty()) {
    located.building_from_robot = trajectory_at(located.places[0], source, mission.placement);
  }
  return located;
}

LocatedMission locate_mission(const AssemblyStore& building, const AsrSource& asked,
                              const RobotFootprint& footprint, const Options& options,
                              const Progress& progress) {
  if (!building.has_assembly()) {
    throw InputError(building.mission().file + ": not assembled; run `roomatlas assemble` first");
  }
  const MissionMap known = mission_map_of(building, placement_of(building.correction()), options);
  return MissionLocator(known, options).locate(asked, footprint, progress);
}

}  // namespace roomatlas
