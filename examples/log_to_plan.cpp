// SPDX-License-Identifier: GPL-3.0-or-later
// From the log of a robot's mission to a floor plan:
//
//     log_to_plan mission.clf plan.svg
#include <exception>
#include <iostream>
#include <roomatlas/roomatlas.hpp>

int main(int argc, char** argv) try {
  using namespace roomatlas;
  if (argc != 3) throw UsageError("usage: log_to_plan LOG PLAN.svg");
  const Options options;  // of all stages

  // Online: as the readings come, each visit to a room becomes a small map of its own, an ASR.
  const auto mission = open_mission_to_map(argv[1], options.mission);
  MemoryStore visits;
  const MapSummary mapped = map_mission(*mission, visits, options.map);

  // Offline: visits are recognised, their poses corrected, and what belongs together is joined.
  const Assembly building = assemble(visits, mission->info().footprint, options);
  const FloorPlan& plan = building.plan;

  std::cout.precision(3);
  std::cout << "visits: " << mapped.asrs << ", rooms: " << plan.rooms.size()
            << ", doors: " << plan.doors.size() << '\n';
  for (const PlanRoom& room : plan.rooms) {
    std::cout << to_string(room.kind) << ' ' << room.name << ": " << room.area_m2 << " m2\n";
  }
  write_file(argv[2], draw_plan(plan, PlanAnnotations{}, DrawOptions{}));
  return 0;
} catch (const std::exception& error) {
  std::cerr << "log_to_plan: " << error.what() << '\n';
  return 1;
}
