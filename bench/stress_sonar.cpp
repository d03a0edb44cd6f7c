// SPDX-License-Identifier: GPL-3.0-or-later
// The batch correction of sonar missions on recorded logs that were altered: other odometry, the
// world in a mirror, driven backwards in time, halves. One row a case; a case whose error is above
// the gate of unseen logs (0.25 m, 3 degrees) is marked as slipped.
//   stress_sonar LOG TRUTH GAP_S [CASE...]     TRUTH: NAME.relations, or poses "time x y theta";
//                                              files below the recorded logs. A case's name may be
//                                              a part of it; no name: all cases
//   environment ROOMATLAS_STRESS_SEED: of noise and of a degraded ring (0: ring as it is)
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

#include "altered_odometry.hpp"
#include "recorded_data.hpp"
#include "roomatlas/evaluate/relations.hpp"
#include "roomatlas/io/logs/open_mission.hpp"
#include "roomatlas/io/trajectories/relations.hpp"
#include "roomatlas/sonar/sonar_trajectory.hpp"

namespace roomatlas {
namespace {

using Readings = std::vector<RangeReading>;

/// What is done to a log.
struct Case {
  const char* name;
  bench::OdometryChange odometry = {};
  double first = 0.0;  ///< share of the log where it begins
  double last = 1.0;
  bool mirrored = false;
  bool backwards = false;
};
constexpr Case kCases[] = {
    {.name = "plain"},
    {.name = "mirrored", .mirrored = true},
    {.name = "backwards", .backwards = true},
    {.name = "first-half", .last = 0.5},
    {.name = "second-half", .first = 0.5},
    {.name = "middle", .first = 0.25, .last = 0.75},
    {"bias+3", {3.0}},
    {"bias-3", {-3.0}},
    {"gain+.05", {0.0, 1.05}},
    {"gain-.05", {0.0, 0.95}},
    {"scale+.04", {0.0, 1.0, 1.04}},
    {"scale-.04", {0.0, 1.0, 0.96}},
    {"noise2", {0.0, 1.0, 1.0, 2.0}},
    {"noise3", {0.0, 1.0, 1.0, 3.0}},
    {"lag+.15", {0.0, 1.0, 1.0, 0.0, 0.15}},
    {"bad", {-3.0, 1.04, 1.04, 1.0}},
    {"worse", {3.0, 1.05, 1.04, 1.5}},
};

Readings readings_of(const Path& log, int seed) {
  MissionOptions options;
  options.as_sonar.enabled = true;
  if (seed > 0) {
    options.as_sonar.seed = static_cast<std::uint64_t>(seed);
    options.as_sonar.range_noise_m = 0.02;
    options.as_sonar.specular_limit_deg = 30.0;
    options.as_sonar.dropout_share = 0.05;
  }
  const auto mission = open_mission(log, options);
  Readings readings;
  while (auto event = mission->next()) {
    if (auto* reading = std::get_if<RangeReading>(&*event)) readings.push_back(std::move(*reading));
  }
  return readings;
}

/// True relative poses over a few ways between the poses of a trajectory in a text file.
std::vector<Relation> relations_of_poses(const Path& file) {
  std::ifstream input(file);
  Trajectory poses;
  for (std::string line; std::getline(input, line);) {
    StampedPose at;
    if (std::sscanf(line.c_str(), "%lf %lf %lf %lf", &at.timestamp_s, &at.pose.x_m, &at.pose.y_m,
                    &at.pose.theta_rad) == 4) {
      poses.push_back(at);
    }
  }
  std::vector<Relation> relations;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    for (const std::size_t ahead : {1, 5, 30, 120, 250}) {
      if (i + ahead >= poses.size()) continue;
      const StampedPose& other = poses[i + ahead];
      relations.push_back(
          {poses[i].timestamp_s, other.timestamp_s, inverse(poses[i].pose) * other.pose});
    }
  }
  return relations;
}

Pose2 in_mirror(const Pose2& pose) { return {pose.x_m, -pose.y_m, wrap_angle(-pose.theta_rad)}; }

void mirror(Readings& readings) {
  std::shared_ptr<const RangeSensor> was;
  std::shared_ptr<const RangeSensor> now;
  for (RangeReading& reading : readings) {
    if (reading.sensor != was) {
      was = reading.sensor;
      RangeSensor sensor = *was;
      for (Pose2& beam : sensor.robot_from_beam) beam = in_mirror(beam);
      now = std::make_shared<const RangeSensor>(std::move(sensor));
    }
    reading.sensor = now;
    reading.odom_from_robot = in_mirror(reading.odom_from_robot);
  }
}

void run(const Case& how, Readings readings, std::vector<Relation> relations, double gap_s,
         int seed) {
  const auto at = [&](double share) {
    return static_cast<std::ptrdiff_t>(share * static_cast<double>(readings.size()));
  };
  readings = Readings(readings.begin() + at(how.first), readings.begin() + at(how.last));
  bench::alter_odometry(readings, how.odometry, seed);
  if (how.mirrored) {
    mirror(readings);
    for (Relation& relation : relations) {
      relation.pose1_from_pose2 = in_mirror(relation.pose1_from_pose2);
    }
  }
  std::vector<double> times_s;
  if (how.backwards) std::reverse(readings.begin(), readings.end());
  for (RangeReading& reading : readings) {
    times_s.push_back(reading.timestamp_s);
    if (how.backwards) reading.timestamp_s = -reading.timestamp_s;
  }
  timespec before{};
  timespec after{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &before);
  const SonarTrajectory result =
      correct_sonar_trajectory(readings, find_drive_directions(readings, {}), {});
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &after);
  Trajectory corrected;
  Trajectory raw;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    corrected.push_back({times_s[i], result.map_from_robot[i]});
    raw.push_back({times_s[i], readings[i].odom_from_robot});
  }
  RelationOptions match;
  if (gap_s > 0.0) match.match = {TimeMatch::nearest, gap_s};
  const auto errors = relation_errors(corrected, relations, match);
  const auto unaided = relation_errors(raw, relations, match);
  const bool slipped = errors.all.translation_m.mean > 0.25 || errors.all.rotation_deg.mean > 3.0;
  const SonarVariant& chosen = result.variants[result.chosen];
  std::printf(
      "%-12s raw %6.2f %5.1f | %6.3f m %5.2f deg, loop %6.3f m | verified %d %s | %s, %.0f "
      "m, %.3f; bias %.2f gain %.3f scale %.3f lag %.2f; %d slips, %d reversed | %.0f s\n",
      how.name, unaided.all.translation_m.mean, unaided.all.rotation_deg.mean,
      errors.all.translation_m.mean, errors.all.rotation_deg.mean, errors.loop.translation_m.mean,
      result.loops_verified, slipped ? "SLIPPED" : "", chosen.name.c_str(), chosen.compared_m,
      chosen.contradiction, degrees(result.habits.bias_rad_per_m), result.habits.turn_gain,
      result.habits.length_scale, result.habits.lag_s, result.slips_repaired,
      result.drives_reversed,
      static_cast<double>(after.tv_sec - before.tv_sec) +
          1e-9 * static_cast<double>(after.tv_nsec - before.tv_nsec));
  std::fflush(stdout);
}

}  // namespace
}  // namespace roomatlas

int main(int argc, char** argv) {
  using namespace roomatlas;
  if (argc < 4) {
    std::fprintf(stderr, "usage: stress_sonar LOG TRUTH GAP_S [CASE...]\n");
    return 2;
  }
  const Path folder = bench::recorded_data() / "logs";
  const char* const seed_text = std::getenv("ROOMATLAS_STRESS_SEED");
  const int seed = seed_text != nullptr ? std::atoi(seed_text) : 0;
  const Readings readings = readings_of(folder / argv[1], seed);
  const std::string truth = argv[2];
  const auto relations = truth.ends_with(".relations") ? read_relations(folder / truth)
                                                       : relations_of_poses(folder / truth);
  for (const Case& one : kCases) {
    if (bench::is_wanted(one.name, {argv + 4, argv + argc})) {
      run(one, readings, relations, std::atof(argv[3]), seed);
    }
  }
  return 0;
}
