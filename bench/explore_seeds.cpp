// SPDX-License-Identifier: GPL-3.0-or-later
// The exploring robot alone, seed after seed: rooms entered, contacts, duration. Odometry does not
// change these drives: the robot explores by its true poses (a test holds that).
//   explore_seeds WORLD.geojson [SEEDS [sonar|laser [FIRST_SEED]]]
// It ends with 1 when a room was not entered or something was touched.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/simulate/explore.hpp"

namespace {

using namespace roomatlas;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2.0;
}

/// Prints one row a seed and the medians; whether all went well.
bool explore_all(const FloorPlan& world, SimulationOptions simulation, std::uint64_t first,
                 std::uint64_t seeds) {
  std::printf("| seed | rooms entered | contacts | duration | path | ended by itself |\n");
  std::printf("|---|---|---|---|---|---|\n");
  std::vector<double> durations_s;
  std::vector<double> lengths_m;
  std::uint64_t clean = 0;
  for (std::uint64_t seed = first; seed < first + seeds; ++seed) {
    simulation.seed = seed;
    const ExploreSummary drive = explore(world, simulation, {}, [](const SimulatedStep&) {});
    durations_s.push_back(drive.duration_s);
    lengths_m.push_back(drive.path_length_m);
    const bool all = drive.entered.size() == world.rooms.size();
    clean += all && drive.collisions == 0 && drive.finished ? 1U : 0U;
    std::printf("| %llu | %zu of %zu | %d | %.0f s | %.0f m | %s |\n",
                static_cast<unsigned long long>(seed), drive.entered.size(), world.rooms.size(),
                drive.collisions, drive.duration_s, drive.path_length_m,
                drive.finished ? "yes" : "no");
    (void)std::fflush(stdout);
  }
  std::printf("| median | %llu of %llu clean | | %.0f s | %.0f m | |\n",
              static_cast<unsigned long long>(clean), static_cast<unsigned long long>(seeds),
              median(durations_s), median(lengths_m));
  return clean == seeds;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: explore_seeds WORLD.geojson [SEEDS [SENSOR [FIRST_SEED]]]\n");
    return 2;
  }
  try {
    SimulationOptions simulation;
    if (argc > 3 && std::string(argv[3]) == "laser") simulation.sensor = SensorKind::laser;
    const int seeds = argc > 2 ? std::max(1, std::atoi(argv[2])) : 20;
    const int first = argc > 4 ? std::max(0, std::atoi(argv[4])) : 1;
    return explore_all(read_plan(argv[1]), simulation, static_cast<std::uint64_t>(first),
                       static_cast<std::uint64_t>(seeds))
               ? 0
               : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "explore_seeds: %s\n", error.what());
    return 3;
  }
}
