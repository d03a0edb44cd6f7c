// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "building_report.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "output_places.hpp"
#include "printable.hpp"
#include "roomatlas/core/counted.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/logs/drive.hpp"
#include "roomatlas/io/logs/mission_writer.hpp"
#include "roomatlas/io/maps/read_world.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/io/results/summary.hpp"
#include "roomatlas/io/trajectories/tum.hpp"
#include "roomatlas/simulate/explore.hpp"
#include "roomatlas/simulate/furnish.hpp"
#include "roomatlas/simulate/random_world.hpp"
#include "roomatlas/simulate/tour.hpp"
#include "roomatlas/simulate/world.hpp"

namespace roomatlas::apps {
namespace {

std::optional<RandomWorldKind> kind_named(const std::string& name) {
  if (name.empty()) return std::nullopt;
  std::string names;
  for (int i = 0; i < kRandomWorldKinds; ++i) {
    const auto kind = static_cast<RandomWorldKind>(i);
    if (name == to_string(kind)) return kind;
    names += std::string(i > 0 ? ", " : "") + to_string(kind);
  }
  throw UsageError("--world-kind: expected one of " + names + ", not '" + name + "'");
}

FloorPlan sound_world(const SimulateArguments& arguments) {
  FloorPlan world = arguments.random_world
                        ? random_world({*arguments.random_world, kind_named(arguments.world_kind),
                                        arguments.world_rooms})
                        : read_world(arguments.world, arguments.file);
  require_sound(world);
  show(world.issues);
  show(check_world(world));
  return world;
}

/// Takes the steps of a mission into its files.
class MissionFiles {
 public:
  MissionFiles(const Settings& settings, const Path& out, const std::string& log)
      : out_(out),
        log_file_(out / log),
        log_(create_mission(log_file_, range_sensor(settings.simulation),
                            settings.simulation.footprint)),
        progress_(console_progress(settings)) {}

  void write(const SimulatedStep& step) {
    log_->write(step);
    truth_.push_back({step.truth.timestamp_s, step.truth.world_from_robot});
    if (!progress_("simulating", -1.0)) throw Interrupted("interrupted: no mission was written");
  }

  void finish(const FloorPlan& world) {
    log_->finish();
    write_tum(out_ / "truth.tum", truth_);
    write_file(out_ / "truth.geojson", to_geojson(world));
    spdlog::info("{} in {}", counted(truth_.size(), "reading"), log_file_.string());
  }

 private:
  Path out_;
  Path log_file_;
  std::unique_ptr<MissionWriter> log_;
  Progress progress_;
  Trajectory truth_;
};

void tell_rest(const ExploreSummary& summary) {
  spdlog::info("the robot told {} and {} apart and gave up {}",
               counted(summary.rooms_found, "space"), counted(summary.doorways_found, "doorway"),
               counted(summary.goals_given_up, "goal"));
  if (!summary.finished) spdlog::warn("the exploration did not end by itself: see --max-time");
}

void report(const ExploreSummary& summary, const FloorPlan& world, bool json) {
  if (json) {
    fmt::print("{}\n", to_json(summary, world));
    return;
  }
  if (world.rooms.empty()) {
    say("{:.0f} s, {:.1f} m driven, {}; the world has no rooms to be counted\n", summary.duration_s,
        summary.path_length_m, counted(summary.collisions, "collision"));
    return tell_rest(summary);
  }
  say("{} of {} entered in {:.0f} s over {:.1f} m, {}\n", summary.entered.size(),
      counted(world.rooms.size(), "room"), summary.duration_s, summary.path_length_m,
      counted(summary.collisions, "collision"));
  tell_rest(summary);
}

std::optional<Pose2> start_of(const std::vector<double>& start) {
  if (start.empty()) return std::nullopt;
  return Pose2{start[0], start[1], wrap_angle(radians(start[2]))};
}

}  // namespace

/// What the robot is to do in the world.
struct Task {
  Drive drive;  ///< empty: it explores
  ExploreOptions explore;
};

/// The drive is read and the start chosen in the empty rooms, so that furniture keeps clear of
/// them.
Task task_in(const FloorPlan& world, const Settings& settings, const SimulateArguments& arguments) {
  Task task{{}, settings.explore};
  if (!arguments.drive.empty()) {
    task.drive = read_drive(arguments.drive);
    return task;
  }
  task.explore.world_from_start = start_of(arguments.start);
  if (!task.explore.world_from_start) {
    task.explore.world_from_start = default_start(world, settings.simulation.footprint);
  }
  return task;
}

FloorPlan furnished_for(const Task& task, FloorPlan world, std::uint64_t seed,
                        const SimulationOptions& simulation) {
  FurnishOptions options;
  options.footprint = simulation.footprint;
  options.route = task.drive;
  if (task.drive.empty()) options.route = {task.explore.world_from_start->position()};
  const std::size_t pieces = world.furniture.size();
  world = furnished(std::move(world), seed, options);
  spdlog::info("{} of furniture put in, {} open",
               counted(world.furniture.size() - pieces, "body", "bodies"),
               counted(open_leaves(world).size(), "door stands", "doors stand"));
  return world;
}

/// Drives as the task says, and hands on what comes of it.
void drive_in(const FloorPlan& world, const Settings& settings, const SimulateArguments& arguments,
              Task task, const std::function<void(const SimulatedStep&)>& sink) {
  if (arguments.tour) {
    task.drive = tour(world, task.explore.world_from_start->position(),
                      {settings.simulation.footprint, TourOptions{}.view_m});
    task.drive =
        driven_within(std::move(task.drive), settings.explore.max_time_s, settings.simulation);
  }
  if (task.drive.empty() && arguments.drive.empty()) {
    report(explore(world, settings.simulation, task.explore, sink), world, settings.json);
  } else {
    roomatlas::simulate(world, task.drive, settings.simulation, sink);
  }
}

void require_sound_carry(const SimulateArguments& arguments) {
  if (arguments.carry_to.empty() != (arguments.carry_at_s <= 0.0)) {
    throw UsageError("simulate: --carry-at and --carry-to go together");
  }
  if (!arguments.carry_to.empty() && !arguments.drive.empty()) {
    throw UsageError("simulate: --carry-at is for a robot that explores or tours, not for --drive");
  }
}

/// Two drives in one log: at a time the robot is carried to another place, and its odometry and
/// clock go on from where they were.
void drive_carried(const FloorPlan& world, Settings settings, const SimulateArguments& arguments,
                   Task task, const std::function<void(const SimulatedStep&)>& sink) {
  const double rest_s = settings.explore.max_time_s - arguments.carry_at_s;
  settings.explore.max_time_s = arguments.carry_at_s;
  task.explore.max_time_s = arguments.carry_at_s;
  OdometryStep last;
  drive_in(world, settings, arguments, task, [&](const SimulatedStep& step) {
    last = step.odometry;
    sink(step);
  });
  settings.simulation.seed += 1;
  settings.simulation.start_timestamp_s = last.timestamp_s + 1.0 / settings.simulation.rate_hz;
  settings.explore.max_time_s = std::max(1.0, rest_s);
  task.explore.max_time_s = settings.explore.max_time_s;
  task.explore.world_from_start = start_of(arguments.carry_to);
  drive_in(world, settings, arguments, task, [&](SimulatedStep step) {
    step.odometry.odom_from_robot = last.odom_from_robot * step.odometry.odom_from_robot;
    step.reading.odom_from_robot = step.odometry.odom_from_robot;
    sink(step);
  });
}

void simulate(const Settings& settings, const SimulateArguments& arguments) {
  const int sources = (arguments.world.empty() ? 0 : 1) + (arguments.random_rooms ? 1 : 0) +
                      (arguments.random_world ? 1 : 0);
  if (sources != 1) {
    throw UsageError("simulate: expected either WORLD, --random-rooms N or --random-world SEED");
  }
  if (!arguments.random_world && (!arguments.world_kind.empty() || arguments.world_rooms != 0)) {
    throw UsageError("simulate: --world-kind and --world-rooms are of --random-world SEED");
  }
  if (arguments.random_rooms)
    return simulate_rooms(settings, *arguments.random_rooms, arguments.out);
  if (arguments.tour && !arguments.drive.empty()) {
    throw UsageError("simulate: expected either --drive FILE or --tour");
  }
  require_sound_carry(arguments);
  FloorPlan world = sound_world(arguments);
  Task task = task_in(world, settings, arguments);
  if (arguments.furnish) {
    world = furnished_for(task, std::move(world), *arguments.furnish, settings.simulation);
  }
  make_folder(arguments.out);
  const PlaceLock lock(arguments.out);
  const std::string log = "mission." + arguments.format;
  for (const std::string& name : {log, std::string("truth.tum"), std::string("truth.geojson")}) {
    require_output_file(arguments.out / name, {arguments.world, arguments.drive});
  }
  MissionFiles files(settings, arguments.out, log);
  const auto write = [&](const SimulatedStep& step) { files.write(step); };
  if (arguments.carry_to.empty()) {
    drive_in(world, settings, arguments, std::move(task), write);
  } else {
    drive_carried(world, settings, arguments, std::move(task), write);
  }
  files.finish(world);
  const bool has_told = !arguments.tour && arguments.drive.empty();  // how it explored
  if (settings.json && !has_told) {
    tell_files(settings, arguments.out, {log, "truth.tum", "truth.geojson"});
  }
}

}  // namespace roomatlas::apps
