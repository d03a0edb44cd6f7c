// SPDX-License-Identifier: GPL-3.0-or-later
// What `compare` finds of simulated alterations, and what it invents where there are none.
//   bench_changes [CASES [SEED [FROM]]]   30 of seed 1, from case 0 on
// Worlds, furniture, alterations, sensors, people, odometry and starts are drawn by seed; every
// third case is not altered. Markdown on stdout.
#include <glog/logging.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "changes/driven_mission.hpp"
#include "changes/score_changes.hpp"
#include "roomatlas/changes/find_changes.hpp"
#include "roomatlas/changes/lay_on.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/simulate/explore.hpp"
#include "roomatlas/simulate/furnish.hpp"
#include "roomatlas/simulate/random_world.hpp"
#include "roomatlas/simulate/tour.hpp"
#include "roomatlas/simulate/world.hpp"

namespace roomatlas::bench {
namespace {

/// A world by its name; the last one is random.
struct NamedWorld {
  std::string name;
  FloorPlan plan;
};

NamedWorld drawn_world(Draw& draw) {
  const std::filesystem::path worlds =
      std::filesystem::path(ROOMATLAS_SOURCE_DIR) / "data" / "worlds";
  const std::vector<std::string> names = {"eight_rooms", "nine_rooms", "open_hall",
                                          "random",      "random",     "random"};
  const std::string name = draw.one_of(names);
  if (name != "random") return {name, read_plan(worlds / (name + ".geojson"))};
  RandomWorldOptions options;
  options.seed = static_cast<std::uint64_t>(draw.whole(1, 1000000));
  options.rooms = draw.whole(4, 10);
  return {to_string(kind_of(options)), random_world(options)};
}

SimulationOptions drawn_robot(Draw& draw) {
  SimulationOptions robot;
  robot.sensor = SensorKind::laser;
  robot.seed = static_cast<std::uint64_t>(draw.whole(1, 1000000));
  robot.odometry =
      odometry_errors(draw.happens(0.5) ? OdometryPreset::mild : OdometryPreset::typical);
  robot.laser_view_deg = draw.happens(0.7) ? 180.0 : 270.0;
  robot.laser.range_noise_m = draw.between(0.005, 0.02);
  robot.people = draw.happens(0.3) ? draw.whole(1, 3) : 0;
  return robot;
}

std::size_t rooms_entered(const FloorPlan& world, const Drive& drive) {
  return static_cast<std::size_t>(
      std::count_if(world.rooms.begin(), world.rooms.end(), [&](const PlanRoom& room) {
        return std::any_of(drive.begin(), drive.end(), [&](const Point2& at) {
          return std::any_of(room.parts.begin(), room.parts.end(),
                             [&](const Polygon& part) { return contains(part, at); });
        });
      }));
}

/// A tour from the middle of some room, of a few the one that enters most: furniture can shut a
/// robot in.
Drive drawn_drive(const FloorPlan& world, const RobotFootprint& footprint, Draw& draw) {
  Drive best;
  for (int attempt = 0; attempt < 6; ++attempt) {
    if (!best.empty() && rooms_entered(world, best) == world.rooms.size()) break;
    const Point2 start = draw.one_of(world.rooms).label_point;
    try {
      require_free(world, start, footprint.length_m);
      Drive drive = tour(world, start, {});
      if (best.empty() || rooms_entered(world, drive) > rooms_entered(world, best)) {
        best = std::move(drive);
      }
    } catch (const InputError&) {
      continue;  // something stands there
    }
  }
  return best.empty() ? tour(world, default_start(world, {}).position(), {}) : best;
}

std::set<RoomId> both(const std::set<RoomId>& a, const std::set<RoomId>& b) {
  std::set<RoomId> common;
  for (const RoomId id : a) {
    if (b.contains(id)) common.insert(id);
  }
  return common;
}

struct Case {
  std::string world;
  bool is_altered = false;
  ChangeScore score;
  double off_m = 0.0;  ///< the farthest pose of both maps from its true place
};

Case run_case(std::uint64_t seed, std::uint64_t number) {
  Draw draw(seed, number);
  const NamedWorld named = drawn_world(draw);
  FurnishOptions furnish;
  furnish.amount = draw.between(0.4, 1.0);
  furnish.route = {default_start(named.plan, {}).position()};
  const FloorPlan world =
      furnished(named.plan, static_cast<std::uint64_t>(draw.whole(1, 1000000)), furnish);
  Case one{named.name, number % 3 != 2, {}, 0.0};
  const AlteredWorld altered_world =
      one.is_altered ? altered(world, draw.whole(3, 7), draw) : AlteredWorld{world, world, {}};

  const SimulationOptions first = drawn_robot(draw);
  const SimulationOptions second = drawn_robot(draw);
  const auto before =
      driven(altered_world.before, drawn_drive(altered_world.before, first.footprint, draw), first);
  const auto after =
      driven(altered_world.after, drawn_drive(altered_world.after, second.footprint, draw), second);
  const Pose2 about{draw.between(-0.4, 0.4), draw.between(-0.4, 0.4),
                    radians(draw.between(-2.0, 2.0))};
  const Pose2 guess = about * inverse(before->world_from_building) * after->world_from_building;
  LayOnOptions lay;
  lay.around = {1.5, radians(6.0)};
  const AssembledMission old_mission = before->mission();
  AssembledMission new_mission = after->mission();
  const std::optional<LaidOn> laid = lay_on(old_mission, new_mission, {guess}, lay);
  const std::set<RoomId> seen = both(before->entered, after->entered);
  if (!laid) {
    one.score = scored(altered_world.alterations, seen, {}, before->world_from_building);
    one.off_m = std::max(before->off_m, after->off_m);
    one.score.remarks.emplace_back("not laid on each other");
    return one;
  }
  new_mission.placement = laid->placement;
  new_mission.plan = moved(std::move(new_mission.plan), laid->old_from_new);
  const PlanChanges found = find_changes(old_mission, new_mission, {});
  one.off_m = std::max(before->off_m, after->off_m);
  one.score = scored(altered_world.alterations, seen, found.changes, before->world_from_building);
  return one;
}

void print_row(const std::string& name, const ChangeScore& score) {
  std::printf("| %s | %d | %d | %d | %d | %.2f |\n", name.c_str(), score.altered, score.found,
              score.named, score.invented, score.f1());
}

constexpr double kRight_m = 0.25;  // a map whose poses are all this near to truth is right

int run(std::uint64_t cases, std::uint64_t seed, std::uint64_t from) {
  ChangeScore altered_sum;
  ChangeScore right_sum;
  ChangeScore same_sum;
  int failed = 0;
  using Clock = std::chrono::steady_clock;
  std::printf("| case | altered | found | named | invented | F1 |\n|---|---|---|---|---|---|\n");
  for (std::uint64_t i = from; i < from + cases; ++i) {
    const auto begun = Clock::now();
    try {
      const Case one = run_case(seed, i);
      (one.is_altered ? altered_sum : same_sum).add(one.score);
      if (one.is_altered && one.off_m <= kRight_m) right_sum.add(one.score);
      print_row(std::to_string(i) + ", " + one.world + (one.is_altered ? "" : ", unaltered"),
                one.score);
      (void)std::fflush(stdout);
      const std::chrono::duration<double> taken = Clock::now() - begun;
      std::fprintf(stderr, "    case %d: maps off by %.2f m at most, %.0f s\n", static_cast<int>(i),
                   one.off_m, taken.count());
      for (const std::string& text : one.score.remarks) {
        std::fprintf(stderr, "    case %d: %s\n", static_cast<int>(i), text.c_str());
      }
    } catch (const std::exception& error) {
      ++failed;
      std::fprintf(stderr, "    case %d: %s\n", static_cast<int>(i), error.what());
    }
  }
  print_row("all altered", altered_sum);
  print_row("of these with both maps right", right_sum);
  print_row("all unaltered", same_sum);
  std::printf("\n%d cases could not be driven.\n", failed);
  return 0;
}

}  // namespace
}  // namespace roomatlas::bench

int main(int argc, char** argv) {
  FLAGS_minloglevel = google::GLOG_FATAL;
  google::InitGoogleLogging(argv[0]);
  const std::uint64_t cases = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 30;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const std::uint64_t from = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 0;
  return roomatlas::bench::run(cases, seed, from);
}
