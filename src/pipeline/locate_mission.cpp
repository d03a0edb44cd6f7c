// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/pipeline/locate_mission.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "roomatlas/asr/with_paths.hpp"
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

/// Softmax of the scores, beside a place that nobody knows and that scores what is asked at least.
void set_odds(double nowhere_score, LocatedMission& located) {
  double best = nowhere_score;
  for (const MissionPlace& place : located.places) best = std::max(best, place.score);
  double sum = std::exp(nowhere_score - best);
  for (const MissionPlace& place : located.places) {
    located.odds.push_back(std::exp(place.score - best));
    sum += located.odds.back();
  }
  for (double& odds : located.odds) odds /= sum;
  located.nowhere_odds = std::exp(nowhere_score - best) / sum;
}

Trajectory trajectory_at(const MissionPlace& place, const AsrSource& source,
                         const Placement& placement) {
  std::map<AsrId, Pose2> building_from_mission;
  for (const PlacedPiece& piece : place.pieces) {
    for (const AsrId id : piece.visits) {
      building_from_mission[id] = piece.place.building_from_query;
    }
  }
  Trajectory trajectory;
  for (const auto& [id, pose] : building_from_mission) {
    const Pose2 building_from_asr = pose * placement.at(id);
    for (const PathSample& sample : source.get(id, AsrDetail::path).path) {
      trajectory.push_back({sample.timestamp_s, building_from_asr * sample.asr_from_robot});
    }
  }
  return trajectory;
}

}  // namespace

PlaceMissionOptions locating_options() {
  PlaceMissionOptions options;
  options.min_agreement = 0.85;  // other buildings reach 0.84 over 5 m of corridor
  options.refurnished.min_agreement = options.min_agreement;
  options.min_score = 15.0;
  options.sure_score = options.min_score;  // a few metres of path have no more
  options.min_margin = 5.0;  // rooms alike differ by up to 3.2, by errors of their maps
  options.margin_sigmas = 0.0;
  options.tried = 12;
  options.places_a_piece = 20;
  return options;
}

LocatedMission locate_mission(const AssemblyStore& building, const AsrSource& asked,
                              const RobotFootprint& footprint, const Options& options,
                              const Progress& progress) {
  if (!building.has_assembly()) {
    throw InputError(building.mission().file + ": not assembled; run `roomatlas assemble` first");
  }
  const Asked mission = corrected(asked, footprint, options, progress);
  report(progress, "locate", -1.0);
  const MissionMap known = mission_map_of(building, placement_of(building.correction()), options);
  const PlaceMissionOptions placing = locating_options();
  const BuildingIndex index(sketch_of(known), placing.locate);
  const AsrSource& recorded = mission.corrected.recorded_again
                                  ? static_cast<const AsrSource&>(*mission.corrected.recorded_again)
                                  : asked;
  const WithPaths source(recorded, mission.corrected.paths);
  const MissionMap query = mission_map_of(source, mission.placement, options);
  const MissionSearch search = place_mission(query, index, placing, progress, options.jobs);
  LocatedMission located;
  located.verdict = search.verdict;
  located.places = search.places;
  set_odds(placing.min_score, located);
  if (!located.places.empty()) {
    located.building_from_robot = trajectory_at(located.places[0], source, mission.placement);
  }
  return located;
}

}  // namespace roomatlas
