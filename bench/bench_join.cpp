// SPDX-License-Identifier: GPL-3.0-or-later
// Missions joined, and how far that is from the truth.
//   bench_join MISSION.gpkg MISSION.gpkg...
// All stores are assembled; where they hold true poses of one world, places are compared with it.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "roomatlas/asr/load.hpp"
#include "roomatlas/evaluate/alignment.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/join/join_missions.hpp"
#include "roomatlas/locate/sonar_shape.hpp"
#include "roomatlas/pipeline/options.hpp"

namespace {

using namespace roomatlas;

AsrShape any_shape_of(const Asr& asr) {
  const Options options;
  const bool is_sonar = asr.readings.front().sensor->kind == SensorKind::sonar;
  return is_sonar ? sonar_shape_of(asr, {})
                  : shape_of(asr, options.map.localize, options.assemble.closures.match);
}

struct Loaded {
  MissionMap map;
  bool has_truth = false;
  Pose2 world_from_mission;
};

Loaded loaded(const std::string& file) {
  const GeoPackageStore store(file, GeoPackageStore::Mode::read);
  Loaded result;
  result.map.mission_from_asr = placement_of(store.correction());
  Trajectory estimate;
  for (const AsrId id : store.ids()) {
    const Asr asr = load_with_readings(store, id);
    result.map.shapes.push_back(any_shape_of(asr));
    result.map.sensor = asr.readings.front().sensor->kind;
    for (const PathSample& sample : asr.path) {
      estimate.push_back(
          {sample.timestamp_s, result.map.mission_from_asr.at(id) * sample.asr_from_robot});
    }
  }
  Trajectory truth;
  for (const TruePose& pose : store.truth())
    truth.push_back({pose.timestamp_s, pose.world_from_robot});
  result.has_truth = !truth.empty();
  if (result.has_truth) {
    result.world_from_mission =
        truth_from_estimate(match_poses(estimate, truth, {}), Alignment::umeyama);
  }
  return result;
}

/// Visits' ids must differ between missions.
Loaded renumbered(Loaded mission, AsrId& next) {
  Placement placement;
  for (AsrShape& shape : mission.map.shapes) {
    placement[next] = mission.map.mission_from_asr.at(shape.id);
    shape.id = next++;
  }
  mission.map.mission_from_asr = placement;
  return mission;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<Loaded> missions;
  AsrId next = 1;
  for (int i = 1; i < argc; ++i) missions.push_back(renumbered(loaded(argv[i]), next));
  std::vector<MissionMap> maps;
  for (const Loaded& mission : missions) maps.push_back(mission.map);
  const auto from = std::chrono::steady_clock::now();
  const JoinedMissions joined = join_missions(maps, {}, {}, 2);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
  std::map<int, std::size_t> base_of;
  for (std::size_t i = 0; i < missions.size(); ++i) {
    if (joined.missions[i].is_base) base_of[joined.missions[i].component] = i;
  }
  for (std::size_t i = 0; i < missions.size(); ++i) {
    const JoinedMission& mission = joined.missions[i];
    const MissionPlace& best = mission.best;
    std::printf("%s: component %d, %s, score %.0f (next %.0f), agreement %.3f, %zu of %zu pieces",
                argv[i + 1], mission.component,
                mission.is_base ? "base" : to_string(mission.verdict), best.score,
                mission.runner_up_score, best.agreement(), best.fitting(), best.pieces.size());
    const Loaded& base = missions[base_of.at(mission.component)];
    if (missions[i].has_truth && base.has_truth) {
      double worst_m = 0.0, worst_deg = 0.0;
      for (const AsrShape& shape : missions[i].map.shapes) {
        const Pose2 truth = inverse(base.world_from_mission) * missions[i].world_from_mission *
                            missions[i].map.mission_from_asr.at(shape.id);
        const Pose2 off = inverse(truth) * joined.placement.at(shape.id);
        worst_m = std::max(worst_m, off.position().norm());
        worst_deg = std::max(worst_deg, std::abs(degrees(off.theta_rad)));
      }
      std::printf("; visits off by at most %.2f m %.2f deg", worst_m, worst_deg);
    }
    std::printf("\n");
  }
  std::map<std::string, int> verdicts;
  for (const Closure& closure : joined.closures) ++verdicts[to_string(closure.verdict)];
  for (const auto& [verdict, count] : verdicts) std::printf("  %s: %d\n", verdict.c_str(), count);
  std::printf("%.1f s\n", seconds);
  return 0;
}
