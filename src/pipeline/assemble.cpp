// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>

#include "close_loops.hpp"
#include "feed_back.hpp"
#include "load.hpp"
#include "map_building.hpp"
#include "record_again.hpp"
#include "report.hpp"
#include "roomatlas/asr/with_paths.hpp"
#include "roomatlas/pipeline/pipeline.hpp"

namespace roomatlas {
namespace {

constexpr double kDoorReachM = 1.0;  // doors this near an outline are cut into it

using EdgeKey = std::pair<AsrId, AsrId>;

std::set<EdgeKey> keys_of(const std::vector<PassageEdge>& edges) {
  std::set<EdgeKey> keys;
  for (const PassageEdge& edge : edges) keys.insert({edge.from, edge.to});
  return keys;
}

struct CorrectedGraph {
  RoomGraph graph;
  Correction correction;
  std::vector<Closure> closures;
  Paths paths;  ///< of readings matched again; may be empty
  bool are_rooms_matched = false;
};

/// The maps of all ASRs, from readings that are loaded for one ASR at a time; none where an ASR was
/// not localized, or its readings were not kept.
std::vector<AsrShape> shapes_of(const AsrSource& source, const std::vector<Asr>& asrs,
                                const ClosureOptions& options) {
  if (!can_map_building(source, asrs)) return {};
  std::vector<AsrShape> shapes;
  for (const Asr& asr : asrs) {
    shapes.push_back(shape_of(load_with_readings(source, asr.id), options));
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

/// Rooms found again by their walls.
CorrectedGraph correct_by_matching(const AsrSource& source, const std::vector<Asr>& asrs,
                                   const std::vector<AsrShape>& shapes,
                                   const AssembleOptions& options, const Progress& progress) {
  CorrectedGraph result;
  result.are_rooms_matched = true;
  result.graph = build_graph(asrs);
  ClosedLoops loops =
      close_loops(asrs, shapes, result.graph, options.correct, options.closures, progress);
  for (const Closure& closure : loops.closures) {
    if (closure.verdict == ClosureVerdict::accepted) add_edge(result.graph, edge_of(closure));
  }
  result.closures = std::move(loops.closures);
  doubt_passages_into(result.graph, loops.lost_before);
  result.correction = correct(asrs, result.graph, options.correct, loops.placement);
  const Placement placement = placement_of(result.correction);
  if (options.feed_back.enabled) {
    result.paths = feed_back(source, shapes, result.closures, placement, options.feed_back);
  }
  return result;
}

/// Recognising doorways needs good poses, and good poses need recognised doorways: both in turn,
/// until nothing new is recognised.
CorrectedGraph correct_in_rounds(const std::vector<Asr>& asrs, const AssembleOptions& options) {
  const RoomGraph driven = build_graph(asrs);
  CorrectedGraph result;
  result.graph = driven;
  result.correction = correct(asrs, driven, options.correct);
  std::set<EdgeKey> known;
  for (int round = 0; round < options.max_rounds; ++round) {
    const std::vector<PassageEdge> recognised =
        recognise_doorways(asrs, placement_of(result.correction), options.recognise);
    if (keys_of(recognised) == known) break;
    known = keys_of(recognised);
    result.graph = driven;
    for (const PassageEdge& edge : recognised) add_edge(result.graph, edge);
    result.correction = correct(asrs, result.graph, options.correct);
  }
  return result;
}

/// Where the ASRs are known to be already, and the direction of the walls there.
struct KnownPlacement {
  Placement placement;
  std::optional<double> walls_rad;
};

/// Rooms that are known to lie right: doorways are recognised where they are.
CorrectedGraph correct_from(const std::vector<Asr>& asrs, const KnownPlacement& known,
                            const AssembleOptions& options) {
  CorrectedGraph result;
  result.graph = build_graph(asrs);
  for (const PassageEdge& edge : recognise_doorways(asrs, known.placement, options.recognise)) {
    add_edge(result.graph, edge);
  }
  result.correction =
      correct_to(asrs, result.graph, known.placement, options.correct, known.walls_rad);
  return result;
}

/// A door of the building as an exit of an ASR: theta points away from the ASR's path.
Exit as_exit_of(const Asr& asr, const Pose2& asr_from_door, double width_m) {
  const auto nearest = std::min_element(
      asr.path.begin(), asr.path.end(), [&](const PathSample& a, const PathSample& b) {
        return (a.asr_from_robot.position() - asr_from_door.position()).squaredNorm() <
               (b.asr_from_robot.position() - asr_from_door.position()).squaredNorm();
      });
  Exit exit;
  exit.asr_from_pivot = asr_from_door;
  const Point2 path_at_door = inverse(asr_from_door) * nearest->asr_from_robot.position();
  if (path_at_door.x() > 0.0) {
    exit.asr_from_pivot.theta_rad = wrap_angle(asr_from_door.theta_rad + kPi);
  }
  exit.width_m = width_m;
  const Point2 half(0.0, width_m / 2.0);
  exit.jambs_asr = {exit.asr_from_pivot * half, exit.asr_from_pivot * Point2(-half)};
  return exit;
}

using DoorsOfRooms = std::map<RoomId, std::vector<BuildingDoor>>;

/// The doors of each room, in their order.
DoorsOfRooms by_room(const std::vector<BuildingDoor>& doors) {
  DoorsOfRooms of_rooms;
  for (const BuildingDoor& door : doors) {
    of_rooms[door.room_a].push_back(door);
    if (door.room_b != door.room_a) of_rooms[door.room_b].push_back(door);
  }
  return of_rooms;
}

/// The doors of an ASR's room near its outline that its own visit did not go through.
std::vector<Exit> other_doors_of(const Asr& asr, RoomId room, const Pose2& building_from_asr,
                                 const DoorsOfRooms& doors) {
  std::vector<Exit> others;
  const auto of_room = doors.find(room);
  if (of_room == doors.end()) return others;
  for (const BuildingDoor& door : of_room->second) {
    const Pose2 asr_from_door = inverse(building_from_asr) * door.building_from_pivot;
    const Point2 at = asr_from_door.position();
    const bool is_near = contains(asr.outline_asr, at) ||
                         distance_to_boundary(asr.outline_asr.outer, at) <= kDoorReachM;
    const bool is_own = std::any_of(asr.exits.begin(), asr.exits.end(), [&](const Exit& exit) {
      return exit.kind == PassageKind::doorway &&
             (exit.asr_from_pivot.position() - at).norm() <= kDoorReachM;
    });
    if (is_near && !is_own) others.push_back(as_exit_of(asr, asr_from_door, door.width_m));
  }
  return others;
}

/// The ASR's outline, cut at every door of its room.
Polygon outline_cut_at_doors(const AsrSource& source, const Asr& asr, RoomId room,
                             const Pose2& building_from_asr, const DoorsOfRooms& doors,
                             const RobotFootprint& footprint, const AssembleOptions& options) {
  const std::vector<Exit> others =
      options.map_again ? other_doors_of(asr, room, building_from_asr, doors) : std::vector<Exit>{};
  if (others.empty()) return asr.outline_asr;
  const Asr whole = source.get(asr.id, AsrDetail::readings);
  if (whole.readings.empty()) return asr.outline_asr;
  std::vector<Exit> exits = asr.exits;
  exits.insert(exits.end(), others.begin(), others.end());
  return map_room(whole.path, whole.readings, exits, footprint, options.record.map).outline;
}

/// Rooms where the readings were not kept, or are not where the robot was: from the ASRs' outlines.
MappedBuilding rooms_by_outlines(const AsrSource& source, const std::vector<Asr>& asrs,
                                 const RoomGraph& graph, const Placement& placement,
                                 const RobotFootprint& footprint, const AssembleOptions& options,
                                 const Progress& progress) {
  MappedBuilding building;
  building.room_of_asr = assign_rooms(asrs, graph, placement, options.rooms);
  building.doors = doors_of(asrs, graph, placement, building.room_of_asr);
  const DoorsOfRooms doors_of_rooms = by_room(building.doors);
  for (const Asr& asr : asrs) {
    report(progress, "outline", share_of(building.outlines.size(), asrs.size()));
    const RoomId room = building.room_of_asr.at(asr.id);
    const Pose2& building_from_asr = placement.at(asr.id);
    const Polygon outline = outline_cut_at_doors(source, asr, room, building_from_asr,
                                                 doors_of_rooms, footprint, options);
    building.outlines.push_back({asr.id, room, transformed(building_from_asr, outline)});
  }
  return building;
}

std::vector<AsrId> asrs_of(RoomId room, const std::map<AsrId, RoomId>& room_of_asr) {
  std::vector<AsrId> asrs;
  for (const auto& [asr, its_room] : room_of_asr) {
    if (its_room == room) asrs.push_back(asr);
  }
  return asrs;
}

/// Passages that closures contradict, said to the user.
Issues lost_on_the_way(const RoomGraph& graph) {
  Issues issues;
  for (const PassageEdge& edge : edges_of(graph)) {
    if (!edge.is_doubtful) continue;
    issues.push_back({Severity::warning, "", 0, "closures",
                      "between visits " + std::to_string(edge.from) + " and " +
                          std::to_string(edge.to) +
                          " the robot was lost: rooms seen again put what follows elsewhere, and "
                          "are believed"});
  }
  return issues;
}

/// By what the mission allows: places that are known, rooms found again, or doorways.
CorrectedGraph corrected_graph(const AsrSource& source, const std::vector<Asr>& asrs,
                               const KnownPlacement& known, const AssembleOptions& options,
                               const Progress& progress) {
  if (!known.placement.empty()) return correct_from(asrs, known, options);
  if (options.match_rooms) {
    const std::vector<AsrShape> shapes = shapes_of(source, asrs, options.closures);
    if (!shapes.empty()) return correct_by_matching(source, asrs, shapes, options, progress);
  }
  return correct_in_rounds(asrs, options);
}

/// Closures that the user added or left out, where none are sought.
Issues unused_closures(const CorrectedGraph& corrected, const ClosureOptions& options) {
  if (corrected.are_rooms_matched || (options.given.empty() && options.without_best <= 0)) {
    return {};
  }
  return {{Severity::warning, "", 0, "closures",
           "those added or left out by the user have no effect: rooms are matched only in missions "
           "with a laser whose readings are localized and kept"}};
}

/// The plan; where walls are made regular, also as it was measured.
void add_plans(MappedBuilding building, const AssembleOptions& options, Assembly& assembly) {
  std::vector<PlacedDoor> doors;
  for (const BuildingDoor& door : building.doors) {
    doors.push_back({jambs_of(door), door.room_a, door.room_b});
  }
  const auto plan_of = [&](const auto& outlines, const auto& placed_doors) {
    FloorPlan plan = merge(outlines, placed_doors, options.merge);
    for (PlanRoom& room : plan.rooms) room.asrs = asrs_of(room.id, building.room_of_asr);
    plan.furniture = building.furniture;
    return plan;
  };
  assembly.plan = plan_of(building.outlines, doors);
  if (!options.regular_walls) return;
  assembly.measured_plan = std::move(assembly.plan);
  RegularWallOptions walls = options.regular;
  if (building.sensor == SensorKind::sonar) walls.blind_corner_m = options.sonar_corner_m;
  const RegularOutlines regular = with_regular_walls(std::move(building.outlines), doors, walls);
  assembly.plan = plan_of(regular.outlines, regular.doors);
  if (regular.kept > 0) {
    assembly.plan.issues.push_back(
        {Severity::note, "", 0, "regular walls",
         std::to_string(regular.kept) + " of " + std::to_string(regular.outlines.size()) +
             " outlines are drawn as measured: straightened they would cross themselves"});
  }
}

/// Everything after the rooms are as true as they will be.
/// @param known may be empty
Assembly assemble_rooms(const AsrSource& source, const KnownPlacement& known,
                        const RobotFootprint& footprint, const AssembleOptions& options,
                        const Progress& progress) {
  const std::vector<Asr> asrs = load(source, AsrDetail::path);
  if (asrs.empty()) throw NotEnoughError("the store holds no ASR: run `roomatlas map` first");

  Assembly assembly;
  report(progress, "correct", 0.0);
  CorrectedGraph corrected = corrected_graph(source, asrs, known, options, progress);
  const Issues unused = unused_closures(corrected, options.closures);
  assembly.closures = std::move(corrected.closures);
  assembly.graph = std::move(corrected.graph);
  assembly.correction = std::move(corrected.correction);
  assembly.paths = std::move(corrected.paths);
  const WithPaths fed_back(source, assembly.paths);
  const Placement placement = placement_of(assembly.correction);

  MappedBuilding building = can_map_building(source, asrs)
                                ? map_building(fed_back, placement, footprint, options, progress)
                                : rooms_by_outlines(source, asrs, assembly.graph, placement,
                                                    footprint, options, progress);
  assembly.room_of_asr = building.room_of_asr;
  assembly.doors = building.doors;
  set_rooms(assembly.graph, assembly.room_of_asr);
  report(progress, "merge", 0.0);
  add_plans(std::move(building), options, assembly);
  for (const Issues& issues : {unused, lost_on_the_way(assembly.graph)}) {
    assembly.plan.issues.insert(assembly.plan.issues.end(), issues.begin(), issues.end());
  }
  return assembly;
}

}  // namespace

Assembly assemble(const AsrSource& source, const RobotFootprint& footprint,
                  const AssembleOptions& options, const Progress& progress) {
  report(progress, "load", 0.0);
  const std::vector<RangeReading> sonars =
      options.correct_sonars ? sonar_readings_of(source) : std::vector<RangeReading>{};
  if (sonars.empty()) return assemble_rooms(source, {}, footprint, options, progress);

  report(progress, "correct sonars", 0.0);
  SonarTrajectory trajectory = correct_sonar_trajectory(
      sonars, options.sonars, [&] { report(progress, "correct sonars", 0.0); });
  RecordedAgain again = record_again(sonars, trajectory.map_from_robot, footprint, options.record);
  const KnownPlacement known{std::move(again.placement), trajectory.walls_rad};
  Assembly assembly = assemble_rooms(again.asrs, known, footprint, options, progress);
  assembly.mapped_again = std::move(again.asrs.asrs);
  trajectory.map_from_robot.clear();
  assembly.sonars = std::move(trajectory);
  return assembly;
}

}  // namespace roomatlas
