// SPDX-License-Identifier: GPL-3.0-or-later
// A mission with a laser whose map is doubted: where sweeps, matched one by one, lost their way,
// its walls as a whole know more.
#include <algorithm>
#include <span>
#include <utility>

#include "roomatlas/asr/load.hpp"
#include "roomatlas/asr/with_paths.hpp"
#include "roomatlas/sonar/single_beams.hpp"
#include "strategies.hpp"

namespace roomatlas {
namespace {

/// Whether somebody said how visits lie, by what they are held, or which answer is meant. A match
/// that is rejected says none of it: the whole does without any.
bool is_decided(const AssembleOptions& options) {
  const ClosureOptions& closures = options.closures;
  return options.answer != 1 || !options.match_rooms || !closures.given.empty() ||
         closures.without_best > 0 ||
         std::any_of(options.edits.begin(), options.edits.end(),
                     [](const Edit& edit) { return edit.kind == EditKind::pin_visits; });
}

/// Nothing where readings are of another sensor, not kept, or too many.
std::optional<std::vector<RangeReading>> single_beams_of(const AsrSource& source,
                                                         std::size_t count) {
  if (count == 0 || count > SingleBeams::kMostReadings) return {};
  SingleBeams beams(count);
  std::vector<RangeReading> readings;
  readings.reserve(count);
  for (const AsrId id : source.ids()) {
    Asr asr = source.get(id, AsrDetail::readings);
    if (asr.readings.empty() || asr.readings.size() != asr.path.size()) return {};
    for (RangeReading& reading : asr.readings) {
      if (reading.sensor->kind != SensorKind::laser) return {};
      readings.push_back(beams.of(std::move(reading)));
    }
  }
  return readings;
}

/// Of each reading, where matched rooms put it.
std::vector<Pose2> matched_poses(const AsrSource& source, const Assembly& matched) {
  const Placement placement = placement_of(matched.correction);
  std::vector<Pose2> poses;
  for (const Asr& asr : load(WithPaths(source, matched.paths), AsrDetail::path)) {
    for (const PathSample& sample : asr.path) {
      poses.push_back(placement.at(asr.id) * sample.asr_from_robot);
    }
  }
  return poses;
}

/// The readings' poses as places of ASRs and paths in them.
/// @param map_from_robot one for each point of their paths
std::pair<Placement, Paths> placed_along(const std::vector<Asr>& asrs,
                                         std::span<const Pose2> map_from_robot) {
  Placement placement;
  Paths paths;
  for (const Asr& asr : asrs) {
    const std::span<const Pose2> poses = map_from_robot.first(asr.path.size());
    const Pose2 map_from_asr = poses.front() * inverse(asr.path.front().asr_from_robot);
    placement[asr.id] = map_from_asr;
    std::vector<Pose2>& path = paths[asr.id];
    path.reserve(poses.size());
    for (const Pose2& pose : poses) path.push_back(inverse(map_from_asr) * pose);
    map_from_robot = map_from_robot.subspan(poses.size());
  }
  return {std::move(placement), std::move(paths)};
}

}  // namespace

std::optional<CorrectedMission> correct_as_a_whole(const AsrSource& source, const Assembly& doubted,
                                                   const Options& options,
                                                   const Progress& progress) {
  const AssembleOptions& assemble = options.assemble;
  if (!assemble.correct_sonars || is_decided(assemble)) return {};
  const std::vector<Pose2> matched = matched_poses(source, doubted);
  auto readings = single_beams_of(source, matched.size());
  if (!readings) return {};
  const auto tell = [&] { report(progress, "correct as a whole", -1.0); };
  tell();
  auto whole = correct_single_beams(std::move(*readings), matched, options.map.directions,
                                    assemble.sonars, tell, options.jobs);
  if (!whole) return {};
  const std::vector<Asr> asrs = load(source, AsrDetail::path);
  auto [placement, paths] = placed_along(asrs, whole->map_from_robot);
  CorrectedMission result;
  result.are_rooms_matched = assemble.match_rooms;
  result.graph = doubted.graph;
  result.closures = doubted.closures;
  result.paths = std::move(paths);
  result.correction = correct_to(asrs, result.graph, placement, assemble.correct, whole->walls_rad);
  result.moves = take_moves(*whole, load(WithPaths(source, result.paths), AsrDetail::path));
  whole->second.reset();  // of walls alone, which matched rooms would have to be asked about
  whole->map_from_robot.clear();
  result.sonars = std::move(*whole);
  result.doubted = doubted.judgement->probability;
  return result;
}

}  // namespace roomatlas
