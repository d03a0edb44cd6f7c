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

#include "roomatlas/join/join_missions.hpp"
#include "roomatlas/pipeline/mission_map.hpp"
#include "store_truth.hpp"

namespace {

using namespace roomatlas;

struct Loaded {
  MissionMap map;
  std::optional<Pose2> world_from_mission;
};

Loaded loaded(const std::string& file) {
  const GeoPackageStore store(file, GeoPackageStore::Mode::read);
  return {mission_map_of(store, placement_of(store.correction()), {}),
          bench::world_from_building(store)};
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
    if (missions[i].world_from_mission && base.world_from_mission) {
      double worst_m = 0.0, worst_deg = 0.0;
      for (const AsrShape& shape : missions[i].map.shapes) {
        const Pose2 truth = inverse(*base.world_from_mission) * *missions[i].world_from_mission *
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
