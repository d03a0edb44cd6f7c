// SPDX-License-Identifier: GPL-3.0-or-later
// A mission with a laser: rooms found again by their walls.
#include "edited_closures.hpp"
#include "roomatlas/asr/load.hpp"
#include "roomatlas/asr/shared_source.hpp"
#include "roomatlas/core/for_each_index.hpp"
#include "roomatlas/loops/close_loops.hpp"
#include "strategies.hpp"

namespace roomatlas {

std::vector<AsrShape> shapes_of(const AsrSource& source, const Options& options) {
  const std::vector<AsrId> ids = source.ids();
  const SharedSource shared(source);
  return results_of<AsrShape>(ids.size(), options.jobs, [&](std::size_t i) {
    return shape_of(shared.load_with_readings(ids[i]), options.map.localize,
                    options.assemble.closures.match);
  });
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

CorrectedMission correct_laser_mission(const AsrSource& source, const Options& options,
                                       const Progress& progress) {
  const AssembleOptions& assemble = options.assemble;
  const std::vector<Asr> asrs = load(source, AsrDetail::path);
  if (!assemble.match_rooms) return correct_paper_mission(asrs, options);
  const std::vector<AsrShape> shapes = shapes_of(source, options);
  CorrectedMission result;
  result.are_rooms_matched = true;
  result.graph = build_graph(asrs);
  ClosureOptions closures = with_edited_closures(source, assemble.edits, assemble.closures);
  closures.take_second = assemble.answer == 2;
  ClosedLoops loops =
      close_loops({asrs, shapes, result.graph}, assemble.correct, closures, progress, options.jobs);
  result.second_loops = loops.second;
  for (const Closure& closure : loops.closures) {
    if (closure.verdict == ClosureVerdict::accepted) add_edge(result.graph, edge_of(closure));
  }
  result.closures = std::move(loops.closures);
  doubt_passages_into(result.graph, loops.lost_before);
  result.correction = correct(asrs, result.graph, assemble.correct, loops.placement);
  if (assemble.feed_back.enabled) {
    result.paths = feed_back(source, shapes, result.closures, placement_of(result.correction),
                             assemble.feed_back, options.jobs);
  }
  return result;
}

}  // namespace roomatlas
