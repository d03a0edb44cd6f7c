// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include "roomatlas/asr/load.hpp"
#include "roomatlas/correct/correct.hpp"
#include "roomatlas/correct/place.hpp"

namespace roomatlas {

PlacedMission place(const AsrSource& source, const Correction& correction) {
  PlacedMission placed;
  for (const AsrCorrection& corrected : correction.asrs) {
    const Asr asr = source.get(corrected.asr, AsrDetail::path);
    for (const PathSample& sample : asr.path) {
      placed.odometry.push_back({sample.timestamp_s, sample.odom_from_robot});
      placed.corrected.push_back(
          {sample.timestamp_s, corrected.building_from_asr * sample.asr_from_robot});
      placed.path_before.push_back(corrected.building_from_asr_before *
                                   sample.asr_from_robot.position());
    }
    for (const WallPolyline& wall : asr.walls) {
      placed.walls_before.push_back(
          transformed(corrected.building_from_asr_before, wall.vertices_asr));
      placed.walls_after.push_back(transformed(corrected.building_from_asr, wall.vertices_asr));
    }
  }
  return placed;
}

RoomGraph graph_of(const AsrSource& source, const Correction& correction) {
  RoomGraph graph = build_graph(load(source, AsrDetail::path));
  const Placement placement = placement_of(correction);
  std::set<std::pair<AsrId, AsrId>> added;
  for (const FactorReport& factor : correction.factors) {
    const bool is_found = factor.kind == FactorKind::doorway || factor.kind == FactorKind::closure;
    if (!is_found || !added.insert({factor.from, factor.to}).second) continue;
    const bool is_doorway = factor.kind == FactorKind::doorway;
    add_edge(graph, {factor.from,
                     factor.to,
                     inverse(placement.at(factor.from)) * placement.at(factor.to),
                     is_doorway ? PassageKind::doorway : PassageKind::open_passage,
                     is_doorway ? EdgeSource::recognised : EdgeSource::matched,
                     0.0,
                     {},
                     Eigen::Matrix3d::Zero(),
                     false});
  }
  return graph;
}

}  // namespace roomatlas
