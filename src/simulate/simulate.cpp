// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/simulate/simulate.hpp"

#include "robot.hpp"
#include "route.hpp"

#include <cmath>

namespace roomatlas {
namespace {

double periods_of(const Route& route, const SimulationOptions& options) {
  return std::ceil(duration_s(route) * options.rate_hz - 1e-9);
}

std::vector<Motion> motions_in_period(const Route& route, double number,
                                      const SimulationOptions& options) {
  return motions_between(route, (number - 1.0) / options.rate_hz, number / options.rate_hz);
}

}  // namespace

Drive driven_within(Drive drive, double time_s, const SimulationOptions& options) {
  const std::vector<Leg> legs = legs_of(drive);
  std::size_t last = legs.front().number;
  auto leg = legs.begin();
  for (const Motion& motion : route_along(legs, options)) {
    if (motion.length_m == 0.0) continue;  // a turn between two legs
    if (motion.start_s + motion.duration_s > time_s) break;
    last = (leg++)->number;
  }
  drive.resize(last + 1);
  return drive;
}

void simulate(const FloorPlan& world, const Drive& drive, const SimulationOptions& options,
              const std::function<void(const SimulatedStep&)>& sink) {
  require_sound(options);
  const std::vector<Leg> legs = legs_of(drive);
  require_clear(world, legs, options.footprint.width_m / 2.0);
  const Route route = route_along(legs, options);
  Robot robot(world, options, world_from_robot_at(route, 0.0));

  sink(robot.start());
  const double last = periods_of(route, options);
  for (double number = 1.0; number <= last; number += 1.0) {
    const Pose2 on_route = robot.world_from_robot();
    if (robot.is_pushed()) {
      const Route back = way_back(robot.world_from_robot(), on_route, options);
      for (double step = 1.0; step <= periods_of(back, options); step += 1.0) {
        sink(robot.step(motions_in_period(back, step, options)));
      }
    }
    sink(robot.step(motions_in_period(route, number, options)));
  }
}

}  // namespace roomatlas
