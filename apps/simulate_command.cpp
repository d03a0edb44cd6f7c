// SPDX-License-Identifier: GPL-3.0-or-later
#include <spdlog/spdlog.h>

#include "commands.hpp"
#include "roomatlas/io/formats.hpp"
#include "roomatlas/simulate/simulate.hpp"

namespace roomatlas::apps {

void simulate(const Settings& settings, const Path& world_file, const Path& drive_file,
              const Path& out) {
  const FloorPlan world = read_plan(world_file);
  const Drive drive = read_drive(drive_file);
  std::filesystem::create_directories(out);
  CarmenWriter log(out / "mission.clf", range_sensor(settings.simulation),
                   settings.simulation.footprint);
  Trajectory truth;
  roomatlas::simulate(world, drive, settings.simulation, [&](const SimulatedStep& step) {
    log.write(step);
    truth.push_back({step.truth.timestamp_s, step.truth.world_from_robot});
  });
  log.finish();
  write_tum(out / "truth.tum", truth);
  write_file(out / "truth.geojson", to_geojson(world));
  spdlog::info("{} readings in {}", truth.size(), (out / "mission.clf").string());
}

}  // namespace roomatlas::apps
