// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulate/simulated.hpp"

#include "roomatlas/io/logs/mission_writer.hpp"
#include "roomatlas/io/maps/read_world.hpp"
#include "roomatlas/simulate/explore.hpp"

#include <vector>

namespace roomatlas::test {

/// Forwards, and a turn on the spot, with everything that is random.
inline std::vector<SimulatedStep> mission_of(SensorKind sensor) {
  SimulationOptions options;
  options.sensor = sensor;
  options.start_timestamp_s = 1700000000.123;
  const Path world = Path(ROOMATLAS_SOURCE_DIR) / "data/worlds/two_rooms.geojson";
  return testing_simulate::run(read_world(world, {}), {{1.5, 2.0}, {3.0, 2.4}, {2.0, 3.4}},
                               options);
}

/// What a robot finds in its first minute.
inline std::vector<SimulatedStep> explored(const FloorPlan& world, SensorKind sensor) {
  SimulationOptions options;
  options.sensor = sensor;
  ExploreOptions of_a_minute;
  of_a_minute.max_time_s = 60.0;
  std::vector<SimulatedStep> steps;
  (void)explore(world, options, of_a_minute,
                [&](const SimulatedStep& step) { steps.push_back(step); });
  return steps;
}

inline void write(const Path& file, const std::vector<SimulatedStep>& steps) {
  const auto writer = create_mission(file, *steps[0].reading.sensor, {});
  for (const SimulatedStep& step : steps) writer->write(step);
  writer->finish();
}

}  // namespace roomatlas::test
