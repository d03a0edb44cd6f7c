// SPDX-License-Identifier: GPL-3.0-or-later
// Where pieces of a log are found in a building: each is mapped, corrected and looked for as
// `roomatlas locate --from --to` does.
//
//   bench_locate BUILDING.gpkg QUERIES.gpkg LOG [--other] [options]
//       LOG          from which QUERIES.gpkg was built, which says where the robot truly was; both
//                    stores hold true poses of one world
//       --other      the log is of another building, and nothing of it may be found
//   bench_locate JOINED.gpkg FOLDER [options]
//       each mission of a joined building in what the others saw; FOLDER has the logs
//   bench_locate train laser|sonar FILE...
//       prints src/join/laser_places.cpp or sonar_places.cpp, from files of samples
// Options: --count N (50) pieces that begin at places drawn at random (--seed N), each --length M
// long (5); --samples FILE to which what was found is added.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "locate/asked_log.hpp"
#include "locate/place_samples.hpp"
#include "roomatlas/pipeline/locate_mission.hpp"
#include "roomatlas/pipeline/mission_map.hpp"
#include "store_truth.hpp"

namespace {

using namespace roomatlas;

struct Arguments {
  std::vector<std::string> words;
  int count = 50;
  unsigned seed = 1;
  double length_m = 5.0;
  bool is_other = false;
  std::string samples;
};

Arguments arguments_of(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--count") {
      arguments.count = std::atoi(argv[++i]);
    } else if (word == "--seed") {
      arguments.seed = static_cast<unsigned>(std::atoi(argv[++i]));
    } else if (word == "--length") {
      arguments.length_m = std::atof(argv[++i]);
    } else if (word == "--samples") {
      arguments.samples = argv[++i];
    } else if (word == "--other") {
      arguments.is_other = true;
    } else {
      arguments.words.push_back(word);
    }
  }
  return arguments;
}

/// Where the robot was in the frame of the building that is asked, in the order of time.
using Truth = Trajectory;

/// As a joined building has it.
Truth truth_of(const GeoPackageStore& store, const std::function<bool(AsrId)>& is_asked) {
  Truth truth;
  const Placement placement = placement_of(store.correction());
  for (const AsrId id : store.ids()) {
    if (!is_asked(id)) continue;
    for (const PathSample& sample : store.get(id, AsrDetail::path).path) {
      truth.push_back({sample.timestamp_s, placement.at(id) * sample.asr_from_robot});
    }
  }
  return truth;
}

/// As the log has it; of another building as that was mapped.
Truth truth_of(const GeoPackageStore& asked, const GeoPackageStore& building, bool is_other) {
  Truth truth = true_poses_of(asked);
  if (is_other || truth.empty()) return truth_of(asked, [](AsrId) { return true; });
  const Pose2 building_from_world = inverse(bench::world_from_building(building).value());
  for (StampedPose& pose : truth) pose.pose = building_from_world * pose.pose;
  return truth;
}

/// Indices of the first and last pose of a piece.
std::pair<std::size_t, std::size_t> piece_from(const Truth& truth, std::size_t first,
                                               double length_m) {
  double way_m = 0.0;
  std::size_t last = first;
  while (last + 1 < truth.size() && way_m < length_m) {
    way_m += (truth[last + 1].pose.position() - truth[last].pose.position()).norm();
    ++last;
  }
  return {first, last};
}

bool is_at(const Trajectory& located, const Truth& truth, std::size_t first, std::size_t last) {
  if (located.empty()) return false;
  const StampedPose& end = located.back();
  for (std::size_t i = first; i <= last; ++i) {
    if (truth[i].timestamp_s != end.timestamp_s) continue;
    const Pose2 off = inverse(truth[i].pose) * end.pose;
    return off.position().norm() < 0.5 && std::abs(degrees(off.theta_rad)) < 10.0;
  }
  return false;
}

bool is_known(const SeenBuilding& seen, const Truth& truth, std::size_t first, std::size_t last) {
  std::size_t on_floor = 0;
  for (std::size_t i = first; i <= last; ++i) {
    on_floor += seen.is_floor(truth[i].pose.position()) ? 1 : 0;
  }
  return 2 * on_floor >= last - first + 1;
}

struct Asking {
  std::string name;
  const MissionMap& known;
  const bench::AskedLog& log;
  const Truth& truth;
};

bench::PlaceSample asked_once(const Asking& asking, const MissionLocator& locator,
                              const SeenBuilding& seen, const Arguments& arguments,
                              std::size_t begin) {
  const auto [first, last] = piece_from(asking.truth, begin, arguments.length_m);
  bench::PlaceSample sample;
  sample.asked = asking.name;
  sample.is_known = !arguments.is_other && is_known(seen, asking.truth, first, last);
  try {
    const MemoryStore asked =
        asking.log.mapped({asking.truth[first].timestamp_s, asking.truth[last].timestamp_s}, {});
    const LocatedMission located = locator.locate(asked, asking.log.footprint());
    sample.sensor = located.sensor;
    sample.is_right =
        !arguments.is_other && is_at(located.building_from_robot, asking.truth, first, last);
    sample.probability = located.odds.empty() ? 0.0 : located.odds[0];
    sample.figures = located.figures;
  } catch (const NotEnoughError&) {
  }
  return sample;
}

/// Asks, and says what came of it in one line.
void ask(const Asking& asking, const Arguments& arguments) {
  const Options options;
  const MissionLocator locator(asking.known, options);
  SeenBuilding seen;
  seen.add(sketch_of(asking.known));
  std::mt19937 random(arguments.seed);
  std::uniform_int_distribution<std::size_t> any(0, asking.truth.size() * 95 / 100);
  std::ofstream samples;
  if (!arguments.samples.empty()) samples.open(arguments.samples, std::ios::app);
  int known = 0, right = 0, sure = 0, wrong = 0;
  for (int n = 0; n < arguments.count; ++n) {
    const bench::PlaceSample sample = asked_once(asking, locator, seen, arguments, any(random));
    const bool is_sure = sample.probability >= kSurePlace;
    known += sample.is_known ? 1 : 0;
    right += sample.is_right ? 1 : 0;
    sure += is_sure ? 1 : 0;
    wrong += is_sure && !sample.is_right ? 1 : 0;
    if (samples.is_open()) samples << line_of(sample) << '\n';
  }
  std::printf(
      "%s, %.1f m: %d queries, %d of them on known floor; likeliest place right in %d; "
      "%d sure, %d of these wrong\n",
      asking.name.c_str(), arguments.length_m, arguments.count, known, right, sure, wrong);
}

std::string name_of(const std::string& file) {
  const std::filesystem::path path(file);
  return path.has_parent_path() ? path.parent_path().filename().string() : path.stem().string();
}

void ask_another(const Arguments& arguments) {
  const GeoPackageStore building(arguments.words[0], GeoPackageStore::Mode::read);
  const GeoPackageStore queries(arguments.words[1], GeoPackageStore::Mode::read);
  const MissionMap known = mission_map_of(building, placement_of(building.correction()), {});
  const Truth truth = truth_of(queries, building, arguments.is_other);
  const bench::AskedLog log(arguments.words[2]);
  ask({name_of(arguments.words[1]) + " in " + name_of(arguments.words[0]), known, log, truth},
      arguments);
}

void ask_members(const Arguments& arguments) {
  const GeoPackageStore building(arguments.words[0], GeoPackageStore::Mode::read);
  const MissionMap all = mission_map_of(building, placement_of(building.correction()), {});
  for (const MemberMission& member : building.members()) {
    const auto is_own = [&](AsrId id) { return id >= member.first_asr && id <= member.last_asr; };
    MissionMap others = all;
    std::erase_if(others.shapes, [&](const AsrShape& shape) { return is_own(shape.id); });
    const bench::AskedLog log(std::filesystem::path(arguments.words[1]) / member.name);
    const Truth truth = truth_of(building, is_own);
    ask({member.name + " in the others of " + name_of(arguments.words[0]), others, log, truth},
        arguments);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const Arguments arguments = arguments_of(argc, argv);
  const std::vector<std::string>& words = arguments.words;
  if (words.size() > 2 && words[0] == "train") {
    const SensorKind sensor = words[1] == "sonar" ? SensorKind::sonar : SensorKind::laser;
    std::printf("%s", bench::learnt_places(
                          bench::read_place_samples({words.begin() + 2, words.end()}), sensor)
                          .c_str());
  } else if (words.size() == 3) {
    ask_another(arguments);
  } else if (words.size() == 2) {
    ask_members(arguments);
  } else {
    std::fprintf(stderr, "bench_locate BUILDING.gpkg QUERIES.gpkg LOG, or JOINED.gpkg FOLDER\n");
    return 2;
  }
  return 0;
}
