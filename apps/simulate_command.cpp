// SPDX-License-Identifier: GPL-3.0-or-later
#include <spdlog/spdlog.h>

#include "commands.hpp"
#include "roomatlas/io/formats.hpp"
#include "roomatlas/simulate/explore.hpp"

namespace roomatlas::apps {
namespace {

void report(const ExploreSummary& summary, const FloorPlan& world) {
  if (!summary.finished) {
    spdlog::warn("the exploration did not finish: see --max-time and --start");
  }
  spdlog::info("explored in {:.0f} s over {:.1f} m: {} of {} rooms entered, {} collisions",
               summary.duration_s, summary.path_length_m, summary.entered.size(),
               world.rooms.size(), summary.collisions);
  spdlog::info("the robot told {} spaces and {} doorways apart and gave up {} goals",
               summary.rooms_found, summary.doorways_found, summary.goals_given_up);
}

}  // namespace

void simulate(const Settings& settings, const Path& world_file, const Path& drive_file,
              const Path& out) {
  const FloorPlan world = read_plan(world_file);
  std::filesystem::create_directories(out);
  CarmenWriter log(out / "mission.clf", range_sensor(settings.simulation),
                   settings.simulation.footprint);
  Trajectory truth;
  const auto write = [&](const SimulatedStep& step) {
    log.write(step);
    truth.push_back({step.truth.timestamp_s, step.truth.world_from_robot});
  };
  if (drive_file.empty()) {
    report(explore(world, settings.simulation, settings.explore, write), world);
  } else {
    roomatlas::simulate(world, read_drive(drive_file), settings.simulation, write);
  }
  log.finish();
  write_tum(out / "truth.tum", truth);
  write_file(out / "truth.geojson", to_geojson(world));
  spdlog::info("{} readings in {}", truth.size(), (out / "mission.clf").string());
}

}  // namespace roomatlas::apps
