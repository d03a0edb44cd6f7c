// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "commands.hpp"
#include "console.hpp"
#include "evaluation_report.hpp"
#include "roomatlas/io/comparison_text.hpp"
#include "roomatlas/io/formats.hpp"
#include "roomatlas/io/geopackage_store.hpp"
#include "roomatlas/io/summary.hpp"
#include "truth_files.hpp"

namespace roomatlas::apps {
namespace {

constexpr const char* kNoTruth =
    "nothing to evaluate against: give --truth FILE (relations, a trajectory or a plan)";

/// A store is an SQLite file, whatever its name.
bool is_store(const Path& file) {
  constexpr std::string_view kMagic = "SQLite format 3";
  std::string head(kMagic.size(), '\0');
  std::ifstream(file, std::ios::binary)
      .read(head.data(), static_cast<std::streamsize>(head.size()));
  return head == kMagic;
}

void require_assembly(const GeoPackageStore& store, const Path& file) {
  if (store.has_assembly()) return;
  throw NotEnoughError(file.string() + ": not assembled yet: run `roomatlas assemble` on it first");
}

void add_poses_in(const GeoPackageStore& store, Truth& truth) {
  for (const TruePose& pose : store.truth()) {
    truth.poses.push_back({pose.timestamp_s, pose.world_from_robot});
  }
}

void add_run(const Settings& settings, const Path& file, const std::string& name,
             std::vector<Run>& runs) {
  if (is_store(file)) {
    const GeoPackageStore store(file, GeoPackageStore::Mode::read);
    require_assembly(store, file);
    PlacedMission placed = place(store, store.correction());
    runs.push_back({name + " odometry", std::move(placed.odometry)});
    runs.push_back({name + " corrected", std::move(placed.corrected)});
    return;
  }
  TrajectoryFile read = read_trajectory(file, settings.mission, LogPoses::recorded);
  show(read.issues);
  runs.push_back({name, std::move(read.poses)});
}

/// Short names, or the paths as given where those would be the same.
std::string name_of(const Path& file, const std::vector<Path>& all) {
  const auto same = std::count_if(all.begin(), all.end(), [&](const Path& other) {
    return other.filename() == file.filename();
  });
  return same > 1 ? file.string() : file.filename().string();
}

Comparison comparison_of(const Settings& settings, const std::vector<Path>& judged,
                         const std::vector<Path>& truth_files, const Preparation& prepare,
                         const CompareOptions& options) {
  Truth truth;
  for (const Path& file : truth_files) add_truth(file, settings, truth);
  std::vector<Run> runs;
  for (const Path& file : judged) add_run(settings, file, name_of(file, judged), runs);
  if (truth.poses.empty() && truth.relations.empty() && is_store(judged.front())) {
    add_poses_in(GeoPackageStore(judged.front(), GeoPackageStore::Mode::read), truth);
  }
  if (truth.poses.empty() && truth.relations.empty()) throw UsageError(kNoTruth);
  for (Run& run : runs) run.trajectory = prepare(run.name, std::move(run.trajectory));
  const std::string name = truth_files.empty() ? "TRUEPOS in the store" : names_of(truth_files);
  return compare(runs, {name, truth.relations, truth.poses}, options, prepare.carry());
}

/// Tells why there is no figure at all, in the words of the first run that says so.
[[noreturn]] void refuse(const Comparison& comparison) {
  for (const JudgedRun& run : comparison.runs) {
    for (const Issue& issue : run.issues) {
      if (issue.severity == Severity::error) throw NotEnoughError(to_string(issue));
    }
  }
  throw NotEnoughError("no figure could be computed");
}

void report(const Settings& settings, const Comparison& comparison, const Preparation& prepare) {
  if (settings.json) {
    fmt::print("{}", to_json(comparison));
  } else {
    print(comparison, prepare.steps());
  }
  for (const JudgedRun& run : comparison.runs) show(run.issues);
}

void report(const Settings& settings, const Evaluation& evaluation) {
  if (settings.json) {
    fmt::print("{}", to_json(evaluation));
  } else {
    print(evaluation);
  }
}

/// What is left of a store's evaluation once its trajectories stand in a table.
Evaluation without_trajectories(Evaluation evaluation) {
  evaluation.relations.reset();
  evaluation.true_poses.reset();
  return evaluation;
}

}  // namespace

Evaluation evaluation_of(const Settings& settings, const Path& store_file,
                         const std::vector<Path>& files, const TrajectoryFlags& flags) {
  const GeoPackageStore store(store_file, GeoPackageStore::Mode::read);
  require_assembly(store, store_file);
  Truth truth;
  add_poses_in(store, truth);
  for (const Path& file : files) add_truth(file, settings, truth);
  const Preparation prepare(flags, settings);
  const Correction correction = store.correction();
  const FloorPlan plan = store.plan();
  const PlacedMission placed = place(store, correction);
  Evaluation evaluation = roomatlas::evaluate(prepare("odometry", placed.odometry),
                                              prepare("corrected", placed.corrected), plan, truth,
                                              prepare.relation_options(), prepare.carry());
  judge_placements(store, correction, plan, truth, evaluation);
  return evaluation;
}

void evaluate(const Settings& settings, const std::vector<Path>& judged,
              const std::vector<Path>& truth, const TrajectoryFlags& flags,
              const ComparisonFiles& files) {
  std::optional<Evaluation> of_store;
  if (judged.size() == 1 && is_store(judged.front())) {
    of_store = evaluation_of(settings, judged.front(), truth, flags);
    if (!of_store->relations && !of_store->true_poses) {
      if (files.any()) throw UsageError(kNoTruth);
      return report(settings, *of_store);
    }
  }
  const Preparation prepare(flags, settings);
  const Comparison comparison = comparison_of(settings, judged, truth, prepare, flags.compare);
  if (!comparison.has_figures()) refuse(comparison);
  if (of_store && settings.json) {
    report(settings, *of_store);
  } else {
    report(settings, comparison, prepare);
    if (of_store) report(settings, without_trajectories(*of_store));
  }
  write(comparison, files);
}

}  // namespace roomatlas::apps
