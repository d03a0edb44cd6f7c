// SPDX-License-Identifier: GPL-3.0-or-later
// The batch correction of sonar missions against relations and simulated truth.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "roomatlas/correct/sonar_trajectory.hpp"
#include "roomatlas/evaluate/relations.hpp"
#include "roomatlas/io/formats.hpp"
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
  std::printf("  %d reversed, %.1f m undecided, %zu segments, %d slips, verified %d, %.1f s\n",
              result.intervals_reversed, result.undecided_m, result.segments, result.slips_repaired,
              result.loops_verified, seconds);
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
  const SonarTrajectory result = correct_sonar_trajectory(readings, {});
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

}  // namespace
}  // namespace roomatlas

int main(int argc, char** argv) {
  using namespace roomatlas;
  const std::string only = argc > 1 ? argv[1] : "";
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
