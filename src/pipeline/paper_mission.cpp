// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's way: odometry, and doorways that were seen again.
#include <set>
#include <utility>

#include "strategies.hpp"

namespace roomatlas {
namespace {

using EdgeKey = std::pair<AsrId, AsrId>;

std::set<EdgeKey> keys_of(const std::vector<PassageEdge>& edges) {
  std::set<EdgeKey> keys;
  for (const PassageEdge& edge : edges) keys.insert({edge.from, edge.to});
  return keys;
}

}  // namespace

CorrectedMission correct_paper_mission(const std::vector<Asr>& asrs, const Options& options) {
  const AssembleOptions& assemble = options.assemble;
  const RoomGraph driven = build_graph(asrs);
  CorrectedMission result;
  result.graph = driven;
  result.correction = correct(asrs, driven, assemble.correct);
  std::set<EdgeKey> known;
  // Recognising doorways needs good poses, and good poses need recognised doorways: both in turn,
  // until nothing new is recognised.
  for (int round = 0; round < assemble.max_rounds; ++round) {
    const std::vector<PassageEdge> recognised =
        recognise_doorways(asrs, placement_of(result.correction), assemble.recognise);
    if (keys_of(recognised) == known) break;
    known = keys_of(recognised);
    result.graph = driven;
    for (const PassageEdge& edge : recognised) add_edge(result.graph, edge);
    result.correction =
        correct(asrs, result.graph, assemble.correct, {}, result.correction.odometry);
  }
  return result;
}

}  // namespace roomatlas
