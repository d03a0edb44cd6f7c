// SPDX-License-Identifier: GPL-3.0-or-later
// A mission with sonars alone: corrected as a whole, its rooms recorded again.
#include <iterator>
#include <utility>

#include "roomatlas/asr/load.hpp"
#include "roomatlas/asr/record_again.hpp"
#include "roomatlas/odometry/drive_directions.hpp"
#include "strategies.hpp"

namespace roomatlas {
namespace {

/// The rigid motion of a visit's frame that moves and turns its poses as much in the mean.
/// @param first of its readings
Pose2 mean_move(const std::vector<Pose2>& moves, const std::vector<std::size_t>& node_of,
                std::size_t first, const std::vector<PathSample>& path) {
  Point2 before = Point2::Zero();
  Point2 after = Point2::Zero();
  double turn_rad = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Pose2& asr_from_robot = path[i].asr_from_robot;
    const Pose2& move = moves[node_of.at(first + i)];
    before += asr_from_robot.position();
    after += asr_from_robot * move.position();
    turn_rad += move.theta_rad;
  }
  const auto count = static_cast<double>(path.size());
  const Pose2 turn{0.0, 0.0, turn_rad / count};
  const Point2 shift = after / count - turn * Point2(before / count);
  return {shift.x(), shift.y(), turn.theta_rad};
}

MovedVisits moved_visits(const DrawnMoves& moves, const std::vector<Asr>& asrs) {
  MovedVisits visits;
  if (moves.of_draw.empty()) return visits;
  std::size_t first = 0;
  for (const Asr& asr : asrs) {
    std::vector<Pose2>& of_visit = visits[asr.id];
    of_visit.reserve(moves.of_draw.size());
    for (const std::vector<Pose2>& draw : moves.of_draw) {
      of_visit.push_back(mean_move(draw, moves.node_of, first, asr.path));
    }
    first += asr.path.size();
  }
  return visits;
}

}  // namespace

std::vector<RangeReading> readings_of(const AsrSource& source) {
  std::vector<RangeReading> readings;
  for (const AsrId id : source.ids()) {
    Asr asr = source.get(id, AsrDetail::readings);
    std::move(asr.readings.begin(), asr.readings.end(), std::back_inserter(readings));
  }
  return readings;
}

VisitMoves take_moves(SonarTrajectory& trajectory, const std::vector<Asr>& asrs) {
  const auto taken = [&](DrawnMoves& moves) {
    return moved_visits(std::exchange(moves, {}), asrs);
  };
  return {taken(trajectory.drawn), taken(trajectory.wild), taken(trajectory.undirected),
          taken(trajectory.cross_check.moves)};
}

CorrectedMission correct_sonar_mission(const AsrSource& source, const RobotFootprint& footprint,
                                       const Options& options, const Progress& progress) {
  report(progress, "correct sonars", -1.0);
  const std::vector<RangeReading> readings = readings_of(source);
  const DriveDirections directions = find_drive_directions(readings, options.map.directions);
  SonarTrajectoryOptions sonars = options.assemble.sonars;
  sonars.take_second = options.assemble.answer == 2;
  SonarTrajectory trajectory = correct_sonar_trajectory(
      readings, directions, sonars, [&] { report(progress, "correct sonars", -1.0); },
      options.jobs);
  RecordedAgain again =
      record_again(readings, trajectory.map_from_robot, footprint, options.map.record);
  report(progress, "correct", -1.0);
  const std::vector<Asr> asrs = load(again.asrs, AsrDetail::path);
  CorrectedMission result;
  result.graph = build_graph(asrs);
  for (const PassageEdge& edge :
       recognise_doorways(asrs, again.placement, options.assemble.recognise)) {
    add_edge(result.graph, edge);
  }
  result.correction = correct_to(asrs, result.graph, again.placement, options.assemble.correct,
                                 trajectory.walls_rad);
  result.moves = take_moves(trajectory, asrs);
  trajectory.map_from_robot.clear();
  result.sonars = std::move(trajectory);
  result.recorded_again = std::move(again.asrs);
  return result;
}

}  // namespace roomatlas
