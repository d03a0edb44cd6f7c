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
#include <iterator>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "roomatlas/asr/load.hpp"
#include "roomatlas/pipeline/locate_mission.hpp"
#include "roomatlas/pipeline/mission_map.hpp"
#include "store_truth.hpp"

namespace {

using namespace roomatlas;

struct Driven {
  std::vector<RangeReading> readings;
  std::vector<Pose2> building_from_robot;
};

Driven driven(const GeoPackageStore& store) {
  Driven all;
  for (const StampedPose& pose : place(store, store.correction()).corrected) {
    all.building_from_robot.push_back(pose.pose);
  }
  for (const AsrId id : store.ids()) {
    Asr asr = load_with_readings(store, id);
    std::move(asr.readings.begin(), asr.readings.end(), std::back_inserter(all.readings));
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

/// What the likeliest places come to.
struct Tally {
  int right = 0;
  int sure = 0;
  int sure_wrong = 0;
  double least_right_margin = 1e9;
  double largest_wrong_margin = 0.0;

  void add(const std::vector<PlaceHypothesis>& places, const Pose2& truth, bool is_other,
           const PlaceMissionOptions& options) {
    const PlaceHypothesis& best = places[0];
    const double margin = best.score - (places.size() > 1 ? places[1].score : 0.0);
    const Pose2 off = inverse(truth) * best.building_from_query;
    const bool is_right =
        !is_other && off.position().norm() < 0.5 && std::abs(degrees(off.theta_rad)) < 10.0;
    const bool is_sure = margin >= options.min_margin && best.score >= options.min_score &&
                         best.agreement() >= options.min_agreement;
    right += is_right ? 1 : 0;
    sure += is_sure ? 1 : 0;
    sure_wrong += is_sure && !is_right ? 1 : 0;
    if (is_right && is_sure) least_right_margin = std::min(least_right_margin, margin);
    if (!is_right) largest_wrong_margin = std::max(largest_wrong_margin, margin);
  }
};

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
  const MissionMap known = mission_map_of(building, placement_of(building.correction()), {});
  const BuildingIndex index(sketch_of(known), {});
  const Pose2 building_from_asked =
      inverse(bench::world_from_building(building).value_or(Pose2{})) *
      bench::world_from_building(queries).value_or(Pose2{});
  const Driven asked = driven(queries);
  std::mt19937 random(1);
  std::uniform_int_distribution<std::size_t> any(0, asked.readings.size() * 95 / 100);
  const PlaceMissionOptions sure = locating_options();
  double seconds = 0.0;
  Tally tally;
  for (int n = 0; n < count; ++n) {
    const std::size_t first = any(random);
    const AsrShape shape = shape_of_visit(piece_of(asked, first, length_m), {});
    const AsrShape* one = &shape;
    const FloorSketch sketch = sketch_of({&one, 1}, {{shape.id, Pose2{}}});
    const auto from = std::chrono::steady_clock::now();
    const auto places = index.find(sketch, 2);
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
    if (places.empty()) continue;
    const Pose2 truth = building_from_asked * asked.building_from_robot[first];
    tally.add(places, truth, is_other, sure);
  }
  std::printf(
      "%s in %s, %.1f m: of %d queries %d sure, %d of these wrong; likeliest place right in %d; "
      "smallest margin of a right one among the sure %.1f, largest of a wrong one %.1f; "
      "%.2f s a query\n",
      files[1].c_str(), files[0].c_str(), length_m, count, tally.sure, tally.sure_wrong,
      tally.right, tally.least_right_margin, tally.largest_wrong_margin, seconds / count);
  return 0;
}
