// SPDX-License-Identifier: GPL-3.0-or-later
// The batch correction of sonar missions against relations and simulated truth.
//   bench_sonar [fr079|aces|mit-killian [SEED]]   a seed degrades the ring: 2 cm of noise, specular
//                                                 loss beyond 30 degrees, 5 % dropped
//   bench_sonar LOG SEED RELATIONS GAP_S          any log; seed 0 leaves the ring as it is
//   bench_sonar worlds [SEEDS [WORLD...]]         simulated, 16 sonars, typical odometry;
//   data/worlds
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "roomatlas/evaluate/relations.hpp"
#include "roomatlas/evaluate/statistics.hpp"
#include "roomatlas/io/logs/open_mission.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/io/trajectories/relations.hpp"
#include "roomatlas/simulate/explore.hpp"
#include "roomatlas/sonar/sonar_trajectory.hpp"
#include "support/shared_data.hpp"

namespace roomatlas {
namespace {

std::vector<RangeReading> readings_of(const Path& log, const MissionOptions& options) {
  const auto mission = open_mission(log, options);
  std::vector<RangeReading> readings;
  while (auto event = mission->next()) {
    if (auto* reading = std::get_if<RangeReading>(&*event)) readings.push_back(std::move(*reading));
  }
  return readings;
}

double cpu_s() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void print(const char* name, const RelationSubset& subset) {
  std::printf("  %-6s %7.4f m %7.3f deg  (max %.2f m)\n", name, subset.translation_m.mean,
              subset.rotation_deg.mean, subset.translation_m.maximum);
}

void report(const SonarTrajectory& result, double seconds) {
  std::printf("  lag %.2f s, bias %.2f deg/m, gain %.3f, scale %.3f, evidence %.1f\n",
              result.habits.lag_s, degrees(result.habits.bias_rad_per_m), result.habits.turn_gain,
              result.habits.length_scale, result.log_evidence);
  std::printf(
      "  %d reversed, %.1f m undecided, %zu segments, %d slips, heading sure in %.0f %%, verified "
      "%d, %.1f s\n",
      result.drives_reversed, result.undecided_m, result.segments, result.slips_repaired,
      100.0 * result.sure_heading_share, result.loops_verified, seconds);
  for (const double direction : result.wall_directions_rad) {
    std::printf("  walls at %.1f deg\n", degrees(direction));
  }
  for (const SonarVariant& variant : result.variants) {
    std::printf("    %-24s %zu pairs, %.0f m compared, contradiction %.4f\n", variant.name.c_str(),
                variant.pairs, variant.compared_m, variant.contradiction);
  }
}

struct Log {
  const char* name;
  const char* file;
  const char* relations;
  double gap_s;
};
constexpr Log kLogs[] = {
    {"fr079", "fr079/fr079.clf.gz", "fr079/fr079.relations", 0.0},
    {"aces", "aces/aces.clf.gz", "aces/aces.relations", 0.0},
    {"mit-killian", "mit-killian/mit-killian.reconstructed.clf.gz",
     "mit-killian/mit-killian.relations", 0.03},
};

void bench_log(const std::string& name, const std::string& log, const std::string& relations,
               double gap_s, const AsSonarOptions& as_sonar) {
  MissionOptions options;
  options.as_sonar = as_sonar;
  const Path folder = test::shared_data_folder() / "logs";  // an absolute name stands for itself
  const auto readings = readings_of(folder / log, options);
  const double before_s = cpu_s();
  const SonarTrajectory result =
      correct_sonar_trajectory(readings, find_drive_directions(readings, {}), {});
  const double seconds = cpu_s() - before_s;
  std::printf("%s: %zu readings\n", name.c_str(), readings.size());
  report(result, seconds);
  Trajectory corrected;
  Trajectory raw;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    corrected.push_back({readings[i].timestamp_s, result.map_from_robot[i]});
    raw.push_back({readings[i].timestamp_s, readings[i].odom_from_robot});
  }
  RelationOptions match;
  if (gap_s > 0.0) match.match = {TimeMatch::nearest, gap_s};
  const auto truth = read_relations(folder / relations);
  const auto errors = relation_errors(corrected, truth, match);
  print("raw", relation_errors(raw, truth, match).all);
  print("all", errors.all);
  print("local", errors.local);
  print("loop", errors.loop);
  std::fflush(stdout);
}

/// A robot explores a world by itself with typical odometry; root mean square and largest error
/// both trajectories beginning at one pose.
void bench_world(const std::string& name, std::uint64_t seed) {
  const FloorPlan world =
      read_plan(Path(ROOMATLAS_SOURCE_DIR) / "data/worlds" / (name + ".geojson"));
  SimulationOptions simulation;
  simulation.seed = seed;
  simulation.odometry = odometry_errors(OdometryPreset::typical);
  std::vector<RangeReading> readings;
  Trajectory truth;
  (void)explore(world, simulation, {}, [&](const SimulatedStep& step) {
    readings.push_back(step.reading);
    truth.push_back({step.truth.timestamp_s, step.truth.world_from_robot});
  });
  const double before_s = cpu_s();
  const SonarTrajectory result =
      correct_sonar_trajectory(readings, find_drive_directions(readings, {}), {});
  const double seconds = cpu_s() - before_s;
  std::vector<double> raw_m;
  std::vector<double> off_m;
  std::vector<double> off_deg;
  const Pose2 world_from_map = truth.front().pose * inverse(readings.front().odom_from_robot);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const Pose2 there = inverse(truth[i].pose);
    raw_m.push_back((there * (world_from_map * readings[i].odom_from_robot)).position().norm());
    const Pose2 off = there * (world_from_map * result.map_from_robot[i]);
    off_m.push_back(off.position().norm());
    off_deg.push_back(degrees(off.theta_rad));
  }
  const Statistics error_m = statistics(off_m);
  const Statistics error_deg = statistics(off_deg);
  std::printf(
      "%s seed %d: raw rmse %.2f m; rmse %.3f m, largest %.2f m, heading median %.2f deg, "
      "verified %d\n",
      name.c_str(), static_cast<int>(seed), statistics(raw_m).rmse, error_m.rmse, error_m.maximum,
      error_deg.median, result.loops_verified);
  report(result, seconds);
  std::fflush(stdout);
}

}  // namespace
}  // namespace roomatlas

int main(int argc, char** argv) {
  using namespace roomatlas;
  const std::string only = argc > 1 ? argv[1] : "";
  if (only == "worlds") {
    const int seeds = argc > 2 ? std::atoi(argv[2]) : 20;
    std::vector<std::string> worlds(argv + std::min(argc, 3), argv + argc);
    if (worlds.empty()) worlds = {"nine_rooms", "afit_floor"};
    for (const std::string& world : worlds) {
      for (int seed = 1; seed <= seeds; ++seed) {
        bench_world(world, static_cast<std::uint64_t>(seed));
      }
    }
    return 0;
  }
  AsSonarOptions as_sonar;
  as_sonar.enabled = true;
  const int seed = argc > 2 ? std::atoi(argv[2]) : 0;
  if (seed > 0) {
    as_sonar.seed = static_cast<std::uint64_t>(seed);
    as_sonar.range_noise_m = 0.02;
    as_sonar.specular_limit_deg = 30.0;
    as_sonar.dropout_share = 0.05;
  }
  if (argc > 4) {
    bench_log(only, only, argv[3], std::atof(argv[4]), as_sonar);
    return 0;
  }
  for (const Log& log : kLogs) {
    if (only.empty() || only == log.name) {
      bench_log(log.name, log.file, log.relations, log.gap_s, as_sonar);
    }
  }
}
