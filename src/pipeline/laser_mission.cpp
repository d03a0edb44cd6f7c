// SPDX-License-Identifier: GPL-3.0-or-later
// A mission with a laser: rooms found again by their walls.
#include "roomatlas/asr/load.hpp"
#include "roomatlas/loops/close_loops.hpp"
#include "strategies.hpp"

namespace roomatlas {
namespace {

/// The maps of all ASRs, from readings that are loaded for one ASR at a time.
std::vector<AsrShape> shapes_of(const AsrSource& source, const Options& options) {
  std::vector<AsrShape> shapes;
  for (const AsrId id : source.ids()) {
    shapes.push_back(shape_of(load_with_readings(source, id), options.map.localize,
                              options.assemble.closures.match));
  }
  return shapes;
}

PassageEdge edge_of(const Closure& closure) {
  PassageEdge edge;
  edge.from = closure.from;
  edge.to = closure.to;
  edge.from_from_to = closure.match.first_from_second;
  edge.kind = PassageKind::open_passage;
  edge.source = EdgeSource::matched;
  edge.information = closure.match.information;
  return edge;
}

}  // namespace

CorrectedMission correct_laser_mission(const AsrSource& source, const Options& options,
                                       const Progress& progress) {
  const AssembleOptions& assemble = options.assemble;
  const std::vector<Asr> asrs = load(source, AsrDetail::path);
  if (!assemble.match_rooms) return correct_paper_mission(asrs, options);
  const std::vector<AsrShape> shapes = shapes_of(source, options);
  CorrectedMission result;
  result.are_rooms_matched = true;
  result.graph = build_graph(asrs);
  ClosedLoops loops =
      close_loops(asrs, shapes, result.graph, assemble.correct, assemble.closures, progress);
  for (const Closure& closure : loops.closures) {
    if (closure.verdict == ClosureVerdict::accepted) add_edge(result.graph, edge_of(closure));
  }
  result.closures = std::move(loops.closures);
  doubt_passages_into(result.graph, loops.lost_before);
  result.correction = correct(asrs, result.graph, assemble.correct, loops.placement);
  if (assemble.feed_back.enabled) {
    result.paths = feed_back(source, shapes, result.closures, placement_of(result.correction),
                             assemble.feed_back);
  }
  return result;
}

}  // namespace roomatlas
