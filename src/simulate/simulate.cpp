// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/simulate/simulate.hpp"

#include "robot.hpp"
#include "route.hpp"

#include <cmath>

namespace roomatlas {

void simulate(const FloorPlan& world, const Drive& drive, const SimulationOptions& options,
              const std::function<void(const SimulatedStep&)>& sink) {
  require_sound(options);
  const std::vector<Leg> legs = legs_of(drive);
  require_clear(world, legs, options.footprint.width_m / 2.0);
  const Route route = route_along(legs, options);
  Robot robot(world, options, world_from_robot_at(route, 0.0));

  sink(robot.start());
  const double last = std::ceil(duration_s(route) * options.rate_hz - 1e-9);
  for (double number = 1.0; number <= last; number += 1.0) {
    sink(robot.step(
        motions_between(route, (number - 1.0) / options.rate_hz, number / options.rate_hz)));
  }
}

}  // namespace roomatlas
