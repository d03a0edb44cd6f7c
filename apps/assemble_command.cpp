// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "commands.hpp"
#include "console.hpp"
#include "roomatlas/io/results/summary.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/io/store/room_names.hpp"
#include "roomatlas/io/trajectories/closures_file.hpp"
#include "roomatlas/merge/carry_over.hpp"
#include "roomatlas/pipeline/assemble.hpp"
#include "store_metadata.hpp"

namespace roomatlas::apps {

namespace {

void report(const SonarTrajectory& sonars) {
  spdlog::info("odometry: {:.2f} s late, {}; {} drives reversed", sonars.habits.lag_s,
               describe(sonars.habits), sonars.drives_reversed);
  if (sonars.variants.empty()) return;
  const SonarVariant& chosen = sonars.variants.at(sonars.chosen);
  spdlog::info(
      "sonars: {} stretches of wall in {} pairs, {:.0f} % of what could be compared "
      "contradicts",
      sonars.segments, chosen.pairs, 100.0 * std::max(0.0, chosen.contradiction));
  if (!sonars.loops_verified) {
    spdlog::warn(
        "loops not verified: what one visit heard as wall, another looked through, or no "
        "place was visited twice");
  }
}

/// The call of the library; nothing is written yet.
Assembly assembly_of(const GeoPackageStore& store, const Path& store_file, const Settings& settings,
                     const RobotFootprint& footprint) {
  Options options = settings;
  if (!settings.add_closures.empty()) {
    options.assemble.closures.given = read_closures(settings.add_closures);
  }
  try {
    return roomatlas::assemble(store, footprint, options, console_progress(settings));
  } catch (const Interrupted& stop) {
    throw Interrupted(fmt::format("{}: {} is as it was; run the same command to assemble it again",
                                  stop.what(), store_file.string()));
  }
}

}  // namespace

std::size_t assemble(const Settings& settings, const Path& store_file) {
  const std::vector<PlanRoom> former = former_rooms(store_file);
  GeoPackageStore store(store_file, GeoPackageStore::Mode::update);
  const Metadata metadata = store.metadata();
  Assembly assembly = assembly_of(store, store_file, settings, footprint_of(metadata));
  const auto mission = metadata.find("mission_file");
  assembly.plan.title = mission == metadata.end() ? "" : mission->second;
  store.put_metadata(metadata_of(assembly, settings));
  if (!assembly.mapped_again.empty()) store.replace_asrs(assembly.mapped_again);
  const CarriedOver carried = carry_over(former, assembly.plan, assembly.room_of_asr);
  store.put_assembly(assembly.correction, assembly.plan, assembly.room_of_asr, assembly.paths);
  if (assembly.measured_plan) {
    renumber(*assembly.measured_plan, carried.number);
    store.put_measured_plan(*assembly.measured_plan);
  }
  store.put_closures(assembly.closures);
  put_former_rooms(store_file, {});
  store.finish();
  show(assembly.plan.issues);
  if (assembly.sonars) report(*assembly.sonars);
  if (!assembly.correction.converged) {
    spdlog::warn("the correction did not converge: {}", assembly.correction.message);
  }
  spdlog::info("{} rooms, {} doors; correction: {} iterations, cost {:.1f} -> {:.1f}",
               assembly.plan.rooms.size(), assembly.plan.doors.size(),
               assembly.correction.iterations, assembly.correction.initial_cost,
               assembly.correction.final_cost);
  return assembly.plan.rooms.size();
}

void require_a_room(std::size_t rooms, const Path& store_file) {
  if (rooms > 0) return;
  throw NotEnoughError(
      store_file.string() +
      ": the plan has no room; all files are written nevertheless. The readings are too few or too "
      "sparse to enclose one: `roomatlas info LOG` shows what was read, and mapping with a larger "
      "--cell needs fewer");
}

}  // namespace roomatlas::apps
