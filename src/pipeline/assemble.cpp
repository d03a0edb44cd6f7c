// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/pipeline/assemble.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "draw_up.hpp"
#include "edited_closures.hpp"
#include "roomatlas/asr/joined_source.hpp"
#include "roomatlas/asr/load.hpp"
#include "roomatlas/asr/with_paths.hpp"
#include "roomatlas/draft/building_axes.hpp"
#include "roomatlas/edit/edit_building.hpp"
#include "roomatlas/rooms/outline_rooms.hpp"
#include "roomatlas/trust/judge_map.hpp"
#include "strategies.hpp"

namespace roomatlas {
namespace {

/// Passages that closures contradict, said to the user.
Issues lost_on_the_way(const RoomGraph& graph) {
  Issues issues;
  for (const PassageEdge& edge : graph.edges) {
    if (!edge.is_doubtful) continue;
    issues.push_back({Severity::warning, "", 0, "closures",
                      "between visits " + std::to_string(edge.from) + " and " +
                          std::to_string(edge.to) +
                          " the robot was lost: rooms seen again put what follows elsewhere, and "
                          "are believed"});
  }
  return issues;
}

/// Closures that the user added or left out, where none are sought.
Issues unused_closures(const CorrectedMission& corrected, const ClosureOptions& options) {
  if (corrected.are_rooms_matched || (options.given.empty() && options.without_best <= 0)) {
    return {};
  }
  return {{Severity::warning, "", 0, "closures",
           "those added or left out by the user have no effect: rooms are matched only in missions "
           "with a laser whose readings are localized and kept"}};
}

/// "3 visits lie elsewhere, up to 4.6 m"
std::string in_words(const SecondLoops& second) {
  const auto decimetres = static_cast<long>(std::lround(10.0 * second.farthest_m));
  return std::to_string(second.visits) +
         (second.visits == 1 ? " visit lies elsewhere, by " : " visits lie elsewhere, by up to ") +
         std::to_string(decimetres / 10) + "." + std::to_string(decimetres % 10) + " m";
}

/// @throws UsageError where the one that is asked for is none of them
Answers answers_of(const CorrectedMission& corrected, int asked) {
  Answers answers;
  answers.drawn = asked;
  if (corrected.sonars && corrected.sonars->second) {
    const SecondAnswer& second = *corrected.sonars->second;
    answers = {asked, 2, second.kept_m, second.score_m, second.name};
  }
  if (corrected.second_loops) {
    const SecondLoops& second = *corrected.second_loops;
    answers = {asked, 2, second.kept_m, second.score_m, in_words(second)};
  }
  if (asked < 1 || asked > answers.count) {
    throw UsageError("--alternative " + std::to_string(asked) + ": the readings have " +
                     (answers.count == 1 ? "one answer, 1" : "two answers, 1 and 2"));
  }
  return answers;
}

bool all_by_sonars(const AsrSource& source) {
  const std::vector<AsrId> ids = source.ids();
  return std::all_of(ids.begin(), ids.end(), [&](AsrId id) {
    const Asr asr = source.get(id, AsrDetail::readings);
    return !asr.readings.empty() &&
           std::all_of(asr.readings.begin(), asr.readings.end(), [](const RangeReading& reading) {
             return reading.sensor->kind == SensorKind::sonar;
           });
  });
}

bool all_localized(const AsrSource& source) {
  const std::vector<AsrId> ids = source.ids();
  return !source.get(ids.front(), AsrDetail::readings).readings.empty() &&
         std::all_of(ids.begin(), ids.end(),
                     [&](AsrId id) { return source.get(id, AsrDetail::geometry).is_localized; });
}

/// On all readings, but for what later missions saw otherwise.
MappedBuilding drafted_of(const AsrSource& source, const std::vector<VisitsOfTime>& times,
                          const RobotFootprint& footprint, const Options& options,
                          const Progress& progress, Assembly& assembly) {
  const DraftBuildingOptions& draft = options.assemble.draft;
  const Placement corrected = placement_of(assembly.correction);
  const Pose2 axes = axes_from_building(source, corrected, draft.evidence, options.jobs);
  const Placement placement = moved(corrected, axes);
  LatestBuilding latest = latest_building(source, placement, times, footprint, options, progress);
  report(progress, "draft", -1.0);
  DraftedBuilding drafted = draft_building(latest.evidence, draft, options.jobs);
  shut(latest.shut_doors, drafted.doors);
  assembly.seen_last = moved(std::move(latest.told), inverse(axes));
  return moved(mapped_building_of(std::move(drafted), latest.evidence, options.map.record.map),
               inverse(axes));
}

MappedBuilding outlined_of(const AsrSource& source, const RobotFootprint& footprint,
                           const Options& options, const Progress& progress,
                           const Assembly& assembly) {
  return rooms_by_outlines(
      source, assembly.graph, placement_of(assembly.correction), footprint,
      {options.assemble.rooms, options.map.record.map, options.assemble.map_again}, progress);
}

bool is_doubtful(const Assembly& assembly) {
  return assembly.judgement && assembly.judgement->probability < kTrusted;
}

/// Which of two, both judged, is more likely right; the first where none is.
Assembly likelier(Assembly first, Assembly second) {
  const bool is_second =
      second.judgement && second.judgement->probability > first.judgement->probability;
  return is_second ? std::move(second) : std::move(first);
}

/// Only where readings lie where the robot was, all that they show can be drawn.
bool is_drafted(MissionKind kind, const Options& options) {
  return kind != MissionKind::paper && options.assemble.plan == PlanStyle::drafted;
}

/// The room that a path comes nearest to; 0 where there is none at all.
RoomId nearest_room(const std::vector<Point2>& path, const std::vector<PlacedOutline>& outlines) {
  RoomId nearest = 0;
  double least_m = std::numeric_limits<double>::infinity();
  for (const PlacedOutline& room : outlines) {
    for (const Point2& at : path) {
      const double away_m = distance_to_boundary(room.outline.outer, at);
      if (!(away_m < least_m)) continue;
      least_m = away_m;
      nearest = room.room;
    }
  }
  return nearest;
}

/// The room in which most of a path lies; of one that is in none, as between the posts of a door,
/// the nearest.
RoomId room_of(const std::vector<Point2>& path, const std::vector<PlacedOutline>& outlines) {
  std::map<RoomId, int> poses;
  for (const Point2& at : path) {
    for (const PlacedOutline& room : outlines) {
      if (contains(room.outline, at)) ++poses[room.room];
    }
  }
  const auto most = std::max_element(
      poses.begin(), poses.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == poses.end() ? nearest_room(path, outlines) : most->first;
}

/// Visits from which nothing was drawn are given to the rooms where their path lies.
void give_rooms(const AsrSource& source, const std::set<AsrId>& visits, const Placement& placement,
                MappedBuilding& building) {
  for (const AsrId id : visits) {
    std::vector<Point2> path;
    for (const PathSample& sample : source.get(id, AsrDetail::path).path) {
      path.push_back(placement.at(id) * sample.asr_from_robot.position());
    }
    building.room_of_asr[id] = room_of(path, building.outlines);
  }
}

/// Applies statements. Visits are given to the rooms that splitting made where their path lies.
Issues edited(const AsrSource& source, const Placement& placement, const std::vector<Edit>& edits,
              MappedBuilding& building) {
  RoomId last = 0;
  for (const PlacedOutline& outline : building.outlines) last = std::max(last, outline.room);
  Issues issues = edit_building(edits, building);
  MappedBuilding by_path = building;
  const bool is_split = std::any_of(building.outlines.begin(), building.outlines.end(),
                                    [&](const PlacedOutline& one) { return one.room > last; });
  if (!is_split) return issues;
  const std::vector<AsrId> ids = source.ids();
  give_rooms(source, {ids.begin(), ids.end()}, placement, by_path);
  for (const auto& [id, room] : by_path.room_of_asr) {
    if (room > last) building.room_of_asr[id] = room;
  }
  return issues;
}

}  // namespace

MissionKind mission_kind(const AsrSource& source, const AssembleOptions& options) {
  if (options.correct_sonars && all_by_sonars(source)) return MissionKind::sonar;
  return all_localized(source) ? MissionKind::laser : MissionKind::paper;
}

CorrectedMission correct_mission(MissionKind kind, const AsrSource& source,
                                 const RobotFootprint& footprint, const Options& options,
                                 const Progress& progress) {
  if (kind == MissionKind::sonar) {
    return correct_sonar_mission(source, footprint, options, progress);
  }
  report(progress, "correct", -1.0);
  return kind == MissionKind::laser ? correct_laser_mission(source, options, progress)
                                    : correct_paper_mission(load(source, AsrDetail::path), options);
}

Assembly assemble_corrected(MissionKind kind, const AsrSource& source, CorrectedMission corrected,
                            const RobotFootprint& footprint, const Options& options,
                            const Progress& progress) {
  const Issues unused = unused_closures(corrected, options.assemble.closures);
  Assembly assembly;
  assembly.answers = answers_of(corrected, options.assemble.answer);
  if (corrected.second_loops) assembly.other_answer = std::move(corrected.second_loops->other);
  assembly.graph = std::move(corrected.graph);
  assembly.correction = std::move(corrected.correction);
  assembly.closures = std::move(corrected.closures);
  assembly.sonars = std::move(corrected.sonars);
  assembly.moves = std::move(corrected.moves);
  assembly.doubted = corrected.doubted;
  assembly.paths = std::move(corrected.paths);

  const AsrSource& recorded = corrected.recorded_again ? *corrected.recorded_again : source;
  const SelectedAsrs drawn = without(recorded, corrected.not_drawn);
  const WithPaths read(drawn, assembly.paths);
  MappedBuilding building =
      is_drafted(kind, options)
          ? drafted_of(read, corrected.times, footprint, options, progress, assembly)
          : outlined_of(read, footprint, options, progress, assembly);
  std::set<AsrId> without_room = corrected.not_drawn;
  for (const AsrId id : drawn.ids()) {  // all of its path lies where something stands by now
    const bool is_lost = !assembly.seen_last.empty() && !building.room_of_asr.contains(id);
    if (is_lost) without_room.insert(id);
  }
  give_rooms(recorded, without_room, placement_of(assembly.correction), building);
  const Issues edits = edited(WithPaths(recorded, assembly.paths),
                              placement_of(assembly.correction), options.assemble.edits, building);
  assembly.room_of_asr = building.room_of_asr;
  assembly.doors = building.doors;
  set_rooms(assembly.graph, assembly.room_of_asr);
  report(progress, "merge", -1.0);
  draw_up(std::move(building), options.assemble, assembly);
  const Issues closures =
      edited_closure_issues(source, options.assemble.edits, assembly.closures,
                            corrected.are_rooms_matched && corrected.are_edits_heard);
  for (const Issues& issues : {unused, lost_on_the_way(assembly.graph), edits, closures}) {
    assembly.plan.issues.insert(assembly.plan.issues.end(), issues.begin(), issues.end());
  }
  report(progress, "judge", -1.0);
  if (kind == MissionKind::sonar && !assembly.sonars) return assembly;  // several missions' sonars
  assembly.judgement = judge_map(map_figures(WithPaths(recorded, assembly.paths), assembly,
                                             options.assemble.correct, options.jobs),
                                 assembly);
  if (assembly.judgement) advise(assembly, options.assemble.correct, *assembly.judgement);
  if (corrected.recorded_again) {
    assembly.mapped_again = std::move(corrected.recorded_again->asrs);
  }
  return assembly;
}

Assembly assemble(const AsrSource& source, const RobotFootprint& footprint, const Options& options,
                  const Progress& progress) {
  report(progress, "load", -1.0);
  if (source.ids().empty()) {
    throw NotEnoughError("the store holds no ASR: run `roomatlas map` first");
  }
  const MissionKind kind = mission_kind(source, options.assemble);
  Assembly assembly =
      assemble_corrected(kind, source, correct_mission(kind, source, footprint, options, progress),
                         footprint, options, progress);
  if (kind != MissionKind::laser || !is_doubtful(assembly)) return assembly;
  auto corrected = correct_as_a_whole(source, assembly, options, progress);
  if (!corrected) return assembly;
  return likelier(std::move(assembly), assemble_corrected(kind, source, std::move(*corrected),
                                                          footprint, options, progress));
}

}  // namespace roomatlas
