// SPDX-License-Identifier: GPL-3.0-or-later
// Laser logs that were altered: fewer readings, a shorter range, noise, other odometry. One row a
// case: how far its poses lie from those of the whole log as it is, laid on them by least squares.
//   stress_laser LOG [CASE...]   a file below the recorded logs; a case's name may be a part of it
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "altered_odometry.hpp"
#include "recorded_data.hpp"
#include "roomatlas/asr/with_paths.hpp"
#include "roomatlas/correct/place.hpp"
#include "roomatlas/evaluate/true_poses.hpp"
#include "roomatlas/io/logs/open_mission.hpp"
#include "roomatlas/pipeline/assemble.hpp"
#include "roomatlas/pipeline/map_mission.hpp"
#include "support/memory_mission.hpp"
#include "support/memory_store.hpp"

namespace roomatlas {
namespace {

using Readings = std::vector<RangeReading>;

struct Case {
  const char* name;
  std::size_t every = 1;       ///< of the readings one in so many is left
  double reach_m = 1e9;        ///< farther returns are lost
  double range_sigma_m = 0.0;  ///< noise
  bench::OdometryChange odometry = {};
};
constexpr Case kCases[] = {
    {.name = "every-3rd", .every = 3},
    {.name = "every-6th", .every = 6},
    {.name = "reach-8m", .reach_m = 8.0},
    {.name = "reach-4m", .reach_m = 4.0},
    {.name = "noise-3cm", .range_sigma_m = 0.03},
    {.name = "odometry-drifts", .odometry = {0.3, 0.99, 1.01, 1.0}},
    {.name = "odometry-is-bad", .odometry = {2.5, 0.95, 1.04, 2.0}},
};

Readings altered(const Readings& whole, const Case& how) {
  Readings readings;
  for (std::size_t i = 0; i < whole.size(); i += how.every) readings.push_back(whole[i]);
  bench::alter_odometry(readings, how.odometry, 1);
  std::mt19937 engine(5);
  std::normal_distribution<double> normal;
  for (RangeReading& reading : readings) {
    for (float& range_m : reading.ranges_m) {
      if (!(range_m > 0.0) || range_m >= reading.sensor->max_range_m) continue;
      const double noisy_m = range_m + how.range_sigma_m * normal(engine);
      range_m = static_cast<float>(range_m > how.reach_m ? reading.sensor->max_range_m
                                                         : std::max(0.02, noisy_m));
    }
  }
  return readings;
}

Trajectory corrected(const Readings& readings, const RobotFootprint& footprint) {
  test::MemoryMission mission({readings.begin(), readings.end()});
  test::MemoryStore store;
  (void)map_mission(mission, store, {});
  const Assembly assembly = assemble(store, footprint, {});
  return place(WithPaths(store, assembly.paths), assembly.correction).corrected;
}

void run(const Case& how, const Readings& whole, const RobotFootprint& footprint,
         const Trajectory& reference) {
  const Trajectory poses = corrected(altered(whole, how), footprint);
  const TruePoseErrors errors = true_pose_errors(poses, reference);
  std::printf("| %s | %zu | %.3f | %.2f |\n", how.name, poses.size(), errors.fitted_position_m.mean,
              errors.fitted_position_m.maximum);
  std::fflush(stdout);
}

}  // namespace
}  // namespace roomatlas

int main(int argc, char** argv) {
  using namespace roomatlas;
  if (argc < 2) {
    std::fprintf(stderr, "usage: stress_laser LOG [CASE...]\n");
    return 2;
  }
  const auto mission = open_mission(bench::recorded_data() / "logs" / argv[1], {});
  Readings readings;
  while (auto event = mission->next()) {
    if (auto* reading = std::get_if<RangeReading>(&*event)) readings.push_back(std::move(*reading));
  }
  const RobotFootprint footprint = mission->info().footprint;
  const Trajectory reference = corrected(readings, footprint);
  std::printf("| %s | readings | position, fitted, mean (m) | most |\n|---|---|---|---|\n",
              argv[1]);
  for (const Case& one : kCases) {
    if (bench::is_wanted(one.name, {argv + 2, argv + argc})) {
      run(one, readings, footprint, reference);
    }
  }
  return 0;
}
