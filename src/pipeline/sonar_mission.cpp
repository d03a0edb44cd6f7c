// SPDX-License-Identifier: GPL-3.0-or-later
// A mission with sonars alone: corrected as a whole, its rooms recorded again.
#include <iterator>

#include "roomatlas/asr/load.hpp"
#include "roomatlas/asr/record_again.hpp"
#include "roomatlas/odometry/drive_directions.hpp"
#include "strategies.hpp"

namespace roomatlas {
std::vector<RangeReading> readings_of(const AsrSource& source) {
  std::vector<RangeReading> readings;
  for (const AsrId id : source.ids()) {
    Asr asr = source.get(id, AsrDetail::readings);
    std::move(asr.readings.begin(), asr.readings.end(), std::back_inserter(readings));
  }
  return readings;
}

DrawnVisits drawn_visits(const DrawnMoves& drawn, const std::vector<Asr>& asrs) {
  DrawnVisits visits;
  if (drawn.of_draw.empty()) return visits;
  std::size_t first = 0;
  for (const Asr& asr : asrs) {
    const Pose2 asr_from_robot = asr.path.front().asr_from_robot;
    for (const std::vector<Pose2>& moves : drawn.of_draw) {
      const Pose2& move = moves[drawn.node_of.at(first)];
      visits[asr.id].push_back(asr_from_robot * move * inverse(asr_from_robot));
    }
    first += asr.path.size();
  }
  return visits;
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
  result.drawn = drawn_visits(trajectory.drawn, asrs);
  trajectory.drawn = {};
  trajectory.map_from_robot.clear();
  result.sonars = std::move(trajectory);
  result.recorded_again = std::move(again.asrs);
  return result;
}

}  // namespace roomatlas
