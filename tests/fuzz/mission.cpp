// SPDX-License-Identifier: GPL-3.0-or-later
#include "mission.hpp"

#include "roomatlas/io/logs/mission_writer.hpp"
#include "roomatlas/io/maps/read_world.hpp"
#include "roomatlas/io/results/summary.hpp"
#include "roomatlas/simulate/simulate.hpp"

namespace roomatlas::fuzz {

void write_mission(const Path& file, SensorKind kind) {
  SimulationOptions options;
  options.sensor = kind;
  options.laser_beams = 11;
  options.sonars = 8;
  std::unique_ptr<MissionWriter> writer;
  const FloorPlan world =
      read_world(Path(ROOMATLAS_SOURCE_DIR) / "data/worlds/two_rooms.geojson", {});
  simulate(world, {{1.5, 2.0}, {1.8, 2.1}}, options, [&](const SimulatedStep& step) {
    if (!writer) writer = create_mission(file, *step.reading.sensor, {});
    writer->write(step);
  });
  writer->finish();
}

void read_whole(MissionSource& mission) {
  while (mission.next()) {
  }
  (void)to_json(mission.info());
  (void)mission.progress();
}

}  // namespace roomatlas::fuzz
