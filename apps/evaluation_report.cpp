// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "console.hpp"
#include "plan_report.hpp"
#include "printable.hpp"

namespace roomatlas::apps {
namespace {

void print_row(const char* subject, const char* when, const char* unit, const Statistics& errors) {
  if (errors.count == 0) return;
  say("  {:<20} {:<8} {:>6}  mean {:>8.3f} {:<3}  std {:>8.3f}  median {:>8.3f}  max {:>8.3f}\n",
      subject, when, errors.count, errors.mean, unit, errors.standard_deviation, errors.median,
      errors.maximum);
}

void print_subset(const char* subject, const RelationSubset& before, const RelationSubset& after) {
  const std::string of(subject);
  print_row((of + " translation").c_str(), "odometry", "m", before.translation_m);
  print_row((of + " translation").c_str(), "corrected", "m", after.translation_m);
  print_row((of + " rotation").c_str(), "odometry", "deg", before.rotation_deg);
  print_row((of + " rotation").c_str(), "corrected", "deg", after.rotation_deg);
}

void print(const RelationsBeforeAfter& relations) {
  say("relations: {} of {} matched ({:.0f} %), {}\n", relations.after.matched,
      relations.after.relations, 100.0 * relations.after.coverage(),
      to_string(relations.after.use));
  print_subset("all", relations.before.all, relations.after.all);
  print_subset("local", relations.before.local, relations.after.local);
  print_subset("loop", relations.before.loop, relations.after.loop);
  show(relations.after.issues);
}

void print(const TruePosesBeforeAfter& poses) {
  say("true poses: {} of {} matched, aligned at the first\n", poses.after.matched,
      poses.after.poses);
  print_row("position", "odometry", "m", poses.before.position_m);
  print_row("position", "corrected", "m", poses.after.position_m);
  print_row("position, fitted", "odometry", "m", poses.before.fitted_position_m);
  print_row("position, fitted", "corrected", "m", poses.after.fitted_position_m);
  print_row("heading", "odometry", "deg", poses.before.heading_deg);
  print_row("heading", "corrected", "deg", poses.after.heading_deg);
}

void print(const MissionErrors& errors) {
  if (errors.relations) {
    print_row("  relations", "corrected", "m", errors.relations->after.all.translation_m);
    print_row("", "", "deg", errors.relations->after.all.rotation_deg);
  }
  print_row("  in the building", "corrected", "m", errors.in_building_m);
  print_row("", "", "deg", errors.in_building_deg);
  if (errors.true_poses) {
    print_row("  by itself, fitted", "corrected", "m", errors.true_poses->after.fitted_position_m);
  }
}

/// A line for each room and a column for each mission: times that the robot came in, and how much
/// of the floor it saw.
void print_rooms(const MissionsFigures& figures) {
  constexpr std::size_t kMostColumns = 8;  // more do not fit a console
  std::map<RoomId, std::vector<std::string>> cells;
  for (std::size_t i = 0; i < figures.missions.size(); ++i) {
    for (const RoomOfMission& room : figures.missions[i].rooms) {
      std::vector<std::string>& line = cells[room.room];
      line.resize(figures.missions.size(), "-");
      const double percent = room.floor_m2 > 0.0 ? 100.0 * room.seen_m2 / room.floor_m2 : 0.0;
      line[i] = fmt::format("{} x {:3.0f} %", room.visits, percent);
    }
  }
  const std::size_t columns = std::min(kMostColumns, figures.missions.size());
  say("  visits x floor seen, by room and mission\n  {:>6}", "room");
  for (std::size_t i = 0; i < columns; ++i) say("  {:>10}", i + 1);
  say("{}\n", columns < figures.missions.size() ? "  ... (--json and the report have all)" : "");
  for (const auto& [room, line] : cells) {
    say("  {:>6}", room);
    for (std::size_t i = 0; i < columns; ++i) say("  {:>10}", line[i]);
    say("\n");
  }
}

void print(const MissionsEvaluation& missions) {
  const MissionsFigures& figures = missions.figures;
  say("missions: {}, {:.0f} m2 of floor\n", figures.missions.size(), figures.floor_m2);
  for (std::size_t i = 0; i < figures.missions.size(); ++i) {
    const MissionFigures& mission = figures.missions[i];
    const auto rooms = std::count_if(mission.rooms.begin(), mission.rooms.end(),
                                     [](const RoomOfMission& room) { return room.visits > 0; });
    say("  {} {} ({}): {:.0f} m in {:.0f} s, {} rooms, {:.0f} % of the floor seen", i + 1,
        mission.name, mission.sensor == SensorKind::laser ? "laser" : "sonar",
        mission.path_length_m, mission.last_s - mission.first_s, rooms,
        figures.floor_m2 > 0.0 ? 100.0 * mission.seen_m2 / figures.floor_m2 : 0.0);
    if (mission.walls_compared_m > 0.0) {
      say("; walls {:.3f} m (rms) from the others' over {:.0f} m", mission.walls_rms_m,
          mission.walls_compared_m);
    }
    say("\n");
    print(missions.errors[i]);
  }
  if (missions.between) {
    print_row("between missions", "corrected", "m", missions.between->all.translation_m);
    print_row("", "", "deg", missions.between->all.rotation_deg);
  }
  for (const MissionPair& pair : figures.pairs) {
    if (pair.accepted == 0) continue;
    say("  {} and {}: {} matches, {:.3f} m and {:.2f} deg (rms) off; {} refused\n", pair.first + 1,
        pair.second + 1, pair.accepted, pair.rms_m, pair.rms_deg, pair.refused);
  }
  print_rooms(figures);
}

}  // namespace

void print(const Evaluation& evaluation) {
  if (evaluation.relations) print(*evaluation.relations);
  if (evaluation.true_poses) print(*evaluation.true_poses);
  if (evaluation.missions) print(*evaluation.missions);
  print_plan_evaluation(evaluation);
  show(evaluation.issues);
}

}  // namespace roomatlas::apps
