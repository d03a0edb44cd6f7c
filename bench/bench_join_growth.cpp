// SPDX-License-Identifier: GPL-3.0-or-later
// How the cost of joining grows with the number of missions.
//   bench_join_growth [BUILDINGS [MOST [SEED]]]   4 buildings, up to 200 missions, seed 1
// A campus of random buildings, each driven twice with a simulated laser. The missions that are
// joined are stretches of these drives, each in a frame of its own and bent a little: as many as
// wanted without mapping each. Processor time, and the exponent over all sizes.
#include <glog/logging.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <string>
#include <vector>

#include "changes/driven_mission.hpp"
#include "everywhere/draw.hpp"
#include "roomatlas/correct/correct.hpp"
#include "roomatlas/join/join_missions.hpp"
#include "roomatlas/pipeline/mission_map.hpp"
#include "roomatlas/simulate/explore.hpp"
#include "roomatlas/simulate/random_world.hpp"
#include "roomatlas/simulate/tour.hpp"

namespace roomatlas::bench {
namespace {

/// Of both drives through each building.
std::vector<MissionMap> driven_campus(int buildings, std::uint64_t seed) {
  std::vector<MissionMap> maps;
  for (int i = 0; i < buildings; ++i) {
    RandomWorldOptions options;
    options.seed = seed * 1000 + static_cast<std::uint64_t>(i);
    options.rooms = 4;
    const FloorPlan world = random_world(options);
    for (std::uint64_t drive = 0; drive < 2; ++drive) {
      SimulationOptions robot;
      robot.sensor = SensorKind::laser;
      robot.seed = options.seed * 10 + drive;
      robot.odometry = odometry_errors(OdometryPreset::mild);
      const auto mission =
          driven(world, tour(world, default_start(world, {}).position(), {}), robot);
      maps.push_back(
          mission_map_of(*mission->source, placement_of(mission->assembly.correction), {}));
      std::fprintf(stderr, "building %d, drive %d: %zu visits\n", i + 1,
                   static_cast<int>(drive) + 1, maps.back().shapes.size());
    }
  }
  return maps;
}

/// A stretch of a drive as a mission of its own.
MissionMap stretch_of(const MissionMap& drive, AsrId& next, Draw& draw) {
  const auto visits = static_cast<int>(drive.shapes.size());
  const int count = std::max(std::min(visits, 4), draw.whole(visits / 2, visits));
  const int first = draw.whole(0, visits - count);
  Pose2 frame{draw.between(-50.0, 50.0), draw.between(-50.0, 50.0),
              radians(draw.between(-180.0, 180.0))};
  MissionMap mission;
  for (int i = first; i < first + count; ++i) {
    const AsrShape& shape = drive.shapes[static_cast<std::size_t>(i)];
    mission.shapes.push_back(shape);
    mission.shapes.back().id = next;
    mission.mission_from_asr[next++] = frame * drive.mission_from_asr.at(shape.id);
    frame = frame * Pose2{draw.between(-0.005, 0.005), draw.between(-0.005, 0.005), 0.0};
  }
  return mission;
}

double processor_s() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Slope of the least-squares line through the logarithms.
double exponent(const std::vector<std::pair<double, double>>& points) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const auto& [count, cost] : points) {
    n += 1.0;
    x += std::log(count);
    y += std::log(cost);
    xx += std::log(count) * std::log(count);
    xy += std::log(count) * std::log(cost);
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

int run(int buildings, int most, std::uint64_t seed) {
  const std::vector<MissionMap> drives = driven_campus(buildings, seed);
  std::printf(
      "| missions | visits | joined | buildings | matches | searches | processor (s) | searching "
      "(s) "
      "| matching again (s) | a mission (s) |\n|---|---|---|---|---|---|---|---|---|---|\n");
  std::vector<std::pair<double, double>> points;
  for (int count = 10; count <= most; count *= 2) {
    Draw draw(seed, 1);
    AsrId next = 1;
    std::vector<MissionMap> missions;
    for (int i = 0; i < count; ++i) {
      const auto drive =
          static_cast<std::size_t>(draw.whole(0, static_cast<int>(drives.size()) - 1));
      missions.push_back(stretch_of(drives[drive], next, draw));
    }
    // Which stage the time since the last report was spent in.
    std::map<std::string, double> spent_s;
    std::string stage = "begin";
    int searches = 0;
    const double from_s = processor_s();
    double last_s = from_s;
    const JoinedMissions joined = join_missions(missions, {}, [&](const std::string& now, double) {
      const double now_s = processor_s();
      spent_s[stage] += now_s - last_s;
      last_s = now_s;
      stage = now;
      searches += now == "join missions" ? 1 : 0;
      return true;
    });
    const double cost_s = processor_s() - from_s;
    spent_s[stage] += processor_s() - last_s;
    int bases = 0;
    for (const JoinedMission& mission : joined.missions) bases += mission.is_base ? 1 : 0;
    std::printf("| %d | %d | %d | %d | %zu | %d | %.1f | %.1f | %.1f | %.2f |\n", count,
                static_cast<int>(next) - 1, count - bases, bases, joined.closures.size(), searches,
                cost_s, spent_s["look for places"], spent_s["join missions again"], cost_s / count);
    std::fflush(stdout);
    points.emplace_back(count, cost_s);
    if (count < most && 2 * count > most) count = most / 2;
  }
  std::printf("\nexponent of the cost over %d to %d missions: %.2f\n",
              static_cast<int>(points.front().first), static_cast<int>(points.back().first),
              exponent(points));
  return 0;
}

}  // namespace
}  // namespace roomatlas::bench

int main(int argc, char** argv) {
  google::InitGoogleLogging(argv[0]);
  FLAGS_minloglevel = google::GLOG_FATAL;
  const int buildings = argc > 1 ? std::atoi(argv[1]) : 4;
  const int most = argc > 2 ? std::atoi(argv[2]) : 200;
  const auto seed = static_cast<std::uint64_t>(argc > 3 ? std::atoll(argv[3]) : 1);
  if (buildings < 1 || most < 20) {
    std::fprintf(stderr, "usage: bench_join_growth [BUILDINGS [MOST [SEED]]], MOST at least 20\n");
    return 2;
  }
  return roomatlas::bench::run(buildings, most, seed);
}
