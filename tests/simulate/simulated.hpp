// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/simulate/simulate.hpp"

#include <vector>

namespace roomatlas::testing_simulate {

inline std::vector<SimulatedStep> run(const FloorPlan& world, const Drive& drive,
                                      const SimulationOptions& options) {
  std::vector<SimulatedStep> steps;
  simulate(world, drive, options, [&](const SimulatedStep& step) { steps.push_back(step); });
  return steps;
}

/// Nothing random, no odometry errors, beams without width, echoes from every angle.
inline SimulationOptions exact() {
  SimulationOptions options;
  options.odometry = {0.0, 0.0, 0.0, 0.0};
  options.sonar = {0.0, 0.0, 90.0, 0.0, 0.0};
  options.sonar_cone_deg = 0.0;
  return options;
}

inline Ring box(double min_x, double min_y, double max_x, double max_y) {
  return {{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}};
}

/// One wall body around the free square from (0, 0) to (4, 4).
inline FloorPlan square_room() {
  FloorPlan world;
  world.walls = {{box(-0.2, -0.2, 4.2, 4.2), {box(0, 0, 4, 4)}}};
  return world;
}

}  // namespace roomatlas::testing_simulate
