// SPDX-License-Identifier: GPL-3.0-or-later
// Where pieces of one mission's path are found in another mission's building.
//   bench_locate BUILDING.gpkg QUERIES.gpkg [--count N] [--length M] [--other]
// Both stores are assembled and hold true poses of one world (of simulated missions, or read with
// the log). Pieces begin at places drawn at random and are M metres long (5). --other: the queries
// are of another building, and none of them may be found.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "roomatlas/asr/load.hpp"
#include "roomatlas/evaluate/alignment.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/locate/building_index.hpp"
#include "roomatlas/locate/sonar_shape.hpp"
#include "roomatlas/pipeline/options.hpp"

namespace {

using namespace roomatlas;

AsrShape any_shape_of(const Asr& asr) {
  const Options options;
  const bool is_sonar = asr.readings.front().sensor->kind == SensorKind::sonar;
  return is_sonar ? sonar_shape_of(asr, {})
                  : shape_of(asr, options.map.localize, options.assemble.closures.match);
}

struct Driven {
  std::vector<RangeReading> readings;
  std::vector<Pose2> building_from_robot;
  Pose2 world_from_building;
};

Driven driven(const GeoPackageStore& store) {
  const Placement placement = placement_of(store.correction());
  Driven all;
  Trajectory estimate;
  for (const AsrId id : store.ids()) {
    Asr asr = store.get(id, AsrDetail::readings);
    for (std::size_t i = 0; i < asr.path.size(); ++i) {
      const Pose2 pose = placement.at(id) * asr.path[i].asr_from_robot;
      all.building_from_robot.push_back(pose);
      estimate.push_back({asr.path[i].timestamp_s, pose});
      all.readings.push_back(std::move(asr.readings[i]));
    }
  }
  Trajectory truth;
  for (const TruePose& pose : store.truth())
    truth.push_back({pose.timestamp_s, pose.world_from_robot});
  if (!truth.empty()) {
    all.world_from_building =
        truth_from_estimate(match_poses(estimate, truth, {}), Alignment::umeyama);
  }
  return all;
}

/// A piece of the path as one visit, in the frame of its first pose.
Asr piece_of(const Driven& mission, std::size_t first, double length_m) {
  Asr asr;
  asr.id = 1;
  const Pose2 query_from_building = inverse(mission.building_from_robot[first]);
  double way_m = 0.0;
  for (std::size_t i = first; i < mission.readings.size() && way_m < length_m; ++i) {
    if (i > first) {
      way_m += (mission.building_from_robot[i].position() -
                mission.building_from_robot[i - 1].position())
                   .norm();
    }
    asr.path.push_back({0.0, query_from_building * mission.building_from_robot[i], {}});
    asr.readings.push_back(mission.readings[i]);
  }
  return asr;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> files;
  int count = 50;
  double length_m = 5.0;
  bool is_other = false;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--count")
      count = std::atoi(argv[++i]);
    else if (word == "--length")
      length_m = std::atof(argv[++i]);
    else if (word == "--other")
      is_other = true;
    else
      files.push_back(word);
  }
  const GeoPackageStore building(files.at(0), GeoPackageStore::Mode::read);
  const GeoPackageStore queries(files.at(1), GeoPackageStore::Mode::read);
  std::vector<AsrShape> shapes;
  for (const AsrId id : building.ids())
    shapes.push_back(any_shape_of(load_with_readings(building, id)));
  std::vector<const AsrShape*> all;
  for (const AsrShape& shape : shapes) all.push_back(&shape);
  const auto begin = std::chrono::steady_clock::now();
  const BuildingIndex index(sketch_of(all, placement_of(building.correction())), {});
  const auto made = std::chrono::steady_clock::now();
  const Driven where = driven(building);
  const Driven asked = driven(queries);
  std::mt19937 random(1);
  std::uniform_int_distribution<std::size_t> any(0, asked.readings.size() * 95 / 100);
  double seconds = 0.0;
  int right = 0;
  for (int n = 0; n < count; ++n) {
    const std::size_t first = any(random);
    const Asr piece = piece_of(asked, first, length_m);
    const AsrShape shape = any_shape_of(piece);
    const AsrShape* one = &shape;
    const FloorSketch sketch = sketch_of({&one, 1}, {{shape.id, Pose2{}}});
    const auto from = std::chrono::steady_clock::now();
    const auto places = index.find(sketch, 2);
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
    if (places.empty()) {
      std::printf("nothing found, %zu walls\n", sketch.walls.size());
      continue;
    }
    const Pose2 truth = inverse(where.world_from_building) * asked.world_from_building *
                        asked.building_from_robot[first];
    int rank = -1;
    double off_m = 1e9, off_deg = 0.0;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const Pose2 off = inverse(truth) * places[k].building_from_query;
      if (off.position().norm() > 0.5 || std::abs(degrees(off.theta_rad)) > 10.0) continue;
      rank = static_cast<int>(k);
      off_m = off.position().norm();
      off_deg = degrees(off.theta_rad);
      break;
    }
    right += rank == 0 ? 1 : 0;
    const PlaceHypothesis& best = places[0];
    const PlaceHypothesis second = places.size() > 1 ? places[1] : PlaceHypothesis{};
    std::printf(
        "%s rank %d off %.2f m %.1f deg | walls %zu floor %zu | best %.1f (%d %d %d %d) second "
        "%.1f (%d %d %d %d)\n",
        is_other ? "other" : (rank == 0 ? "right" : "WRONG"), rank, off_m, off_deg,
        sketch.walls.size(), sketch.floor.size(), best.score, best.agreeing, best.contradicting,
        best.unseen, best.missing, second.score, second.agreeing, second.contradicting,
        second.unseen, second.missing);
  }
  std::printf("%d of %d right; index %.2f s, a query %.3f s\n", right, count,
              std::chrono::duration<double>(made - begin).count(), seconds / count);
  return 0;
}
