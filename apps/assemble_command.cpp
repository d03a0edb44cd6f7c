// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "commands.hpp"
#include "console.hpp"
#include "roomatlas/core/counted.hpp"
#include "roomatlas/io/results/summary.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/io/trajectories/closures_file.hpp"
#include "roomatlas/pipeline/assemble_store.hpp"
#include "store_edits.hpp"
#include "stored_configuration.hpp"

namespace roomatlas::apps {

namespace {

void report(const SonarTrajectory& sonars) {
  spdlog::info("odometry: {:.2f} s late, {}; {} reversed", sonars.habits.lag_s,
               describe(sonars.habits), counted(sonars.drives_reversed, "drive"));
  if (sonars.variants.empty()) return;
  const SonarVariant& chosen = sonars.variants.at(sonars.chosen);
  spdlog::info(
      "corrected as a whole: {} of wall in {}, {:.1f} % of {:.0f} m that could be compared "
      "contradicts, headings of {:.1f} % of the readings are sure",
      counted(sonars.segments, "stretch", "stretches"), counted(chosen.pairs, "pair"),
      100.0 * std::max(0.0, chosen.contradiction), chosen.compared_m,
      100.0 * sonars.sure_heading_share);
}

/// How far the map can be relied on.
void report(const Judgement& judgement) {
  const double percent = std::min(99.0, 100.0 * judgement.probability);
  spdlog::info(
      "right with a probability of {:.0f} %; 9 of 10 rooms within {:.2f} m, lengths within "
      "{:.1f} %, headings within {:.1f} deg",
      percent, std::max(0.01, judgement.place_m), 100.0 * judgement.scale_share,
      judgement.heading_deg);
  if (judgement.probability >= kTrusted) return;
  std::string reasons;
  for (const Doubt& doubt : judgement.doubts) {
    reasons += (reasons.empty() ? ": " : "; ") + doubt.text;
  }
  spdlog::warn("this map may be wrong (right with {:.0f} %){}", percent, reasons);
  for (const Advice& advice : judgement.advice) {
    spdlog::info(
        "what would help: {} ({:.0f} m; the least sure place from {:.2f} to {:.2f} m, heading from "
        "{:.1f} to {:.1f} deg)",
        words(advice), advice.drive_m, advice.place_before_m, advice.place_after_m,
        advice.heading_before_deg, advice.heading_after_deg);
  }
  if (judgement.visits.size() > kMostAdvised) {
    spdlog::info("what would help is not worked out for more than {} visits together",
                 kMostAdvised);
  }
}

void report(const Answers& answers, const Path& store_file) {
  if (answers.count < 2) return;
  const std::string draws =
      fmt::format("`roomatlas assemble {} --alternative {}` draws {}", store_file.string(),
                  answers.drawn == 1 ? 2 : 1, answers.drawn == 1 ? "it" : "that one");
  spdlog::warn("{}: {}", words(answers), draws);
}

/// The call of the library, which puts all of it into the store.
Assembly assembled(const Settings& settings, const Path& store_file) {
  Settings used = settings;
  if (!used.add_closures.empty()) {
    used.assemble.closures.given = read_closures(used.add_closures);
  }
  used.assemble.edits = edits_for(used, GeoPackageStore(store_file, GeoPackageStore::Mode::read));
  GeoPackageStore store(store_file, GeoPackageStore::Mode::update);
  try {
    Assembly assembly = assemble_store(store, used, used.as_toml, console_progress(used));
    keep_edits(used.assemble.edits, store);
    store.finish();
    return assembly;
  } catch (const Interrupted& stop) {
    throw Interrupted(fmt::format("{}: {} is as it was; run the same command to assemble it again",
                                  stop.what(), store_file.string()));
  }
}

}  // namespace

std::size_t assemble_again(const Settings& settings, const Path& store_file, int alternative,
                           const std::vector<std::string>& missions) {
  const Metadata metadata = GeoPackageStore(store_file, GeoPackageStore::Mode::read).metadata();
  Settings used = as_recorded(settings, metadata, store_file);
  used.assemble.answer = alternative;
  used.assemble.missions = missions;
  return assemble(used, store_file);
}

std::size_t assemble(const Settings& settings, const Path& store_file) {
  const Assembly assembly = assembled(settings, store_file);
  show(assembly.plan.issues);
  if (assembly.sonars) report(*assembly.sonars);
  if (assembly.judgement && !assembly.plan.rooms.empty()) report(*assembly.judgement);
  report(assembly.answers, store_file);
  show(assembly.seen_last, store_file);
  if (!assembly.correction.converged) {
    spdlog::warn("the correction did not converge: {}", assembly.correction.message);
  }
  spdlog::info("{}, {}", counted(assembly.plan.rooms.size(), "room"), openings_text(assembly.plan));
  spdlog::debug("correction: {}, cost {:.1f} -> {:.1f}",
                counted(assembly.correction.iterations, "iteration"),
                assembly.correction.initial_cost, assembly.correction.final_cost);
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
