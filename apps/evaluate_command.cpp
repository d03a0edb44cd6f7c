// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "commands.hpp"
#include "console.hpp"
#include "evaluation_report.hpp"
#include "output_places.hpp"
#include "plan_report.hpp"
#include "roomatlas/correct/place.hpp"
#include "roomatlas/io/files/path.hpp"
#include "roomatlas/io/logs/open_mission.hpp"
#include "roomatlas/io/results/comparison_text.hpp"
#include "roomatlas/io/results/summary.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/pipeline/answer_trajectory.hpp"
#include "roomatlas/pipeline/evaluate_store.hpp"
#include "stored_configuration.hpp"
#include "truth_files.hpp"
#include "usable_store.hpp"

namespace roomatlas::apps {
namespace {

constexpr const char* kNoTruth =
    ": nothing to judge this trajectory by: give --truth FILE with relations or a trajectory";
constexpr const char* kOwnTruth = "TRUEPOS in the store";

Evaluation evaluation_of(const GeoPackageStore& store, const Truth& truth,
                         const Preparation& prepare, int jobs) {
  require_assembled(store);
  return evaluate_store(store, truth, {prepare, prepare.relation_options(), prepare.carry()}, jobs);
}

/// What the files on the command line hold.
struct Judged {
  std::vector<Run> runs;
  std::vector<JudgedPlan> plans;
  std::vector<Path> bare;  ///< trajectories that bring no truth of their own
};

bool is_plan(const Path& file) {
  const std::string extension = kind_of(file);
  return extension == ".geojson" || extension == ".json" || extension == ".pgm";
}

/// A store of several missions: all together, and each among what is said of the plan.
void add_missions(const GeoPackageStore& store, const std::string& name, const Truth& truth,
                  const Preparation& prepare, Evaluation& evaluation, Judged& judged) {
  JoinedPaths paths =
      joined_paths(store, truth, {prepare, prepare.relation_options(), prepare.carry()});
  const auto add = [&](const std::string& what, Trajectory trajectory) {
    judged.runs.push_back({name + what, std::move(trajectory), paths.poses, paths.relations});
  };
  add(" odometry", std::move(paths.all_odometry));
  add(" corrected", std::move(paths.all_corrected));
  evaluation.relations.reset();  // stand in the comparison
  evaluation.true_poses.reset();
  judged.plans.push_back({name, std::move(evaluation)});
}

/// Of several answers the one that is not drawn: the truth decides.
void add_other_answer(const Settings& settings, const Path& file, const std::string& name,
                      const Trajectory& true_poses, const Preparation& prepare, Judged& judged) {
  const GeoPackageStore store(file, GeoPackageStore::Mode::read_as_mapped);
  const Metadata metadata = store.metadata();
  const Answers answers = answers_in(metadata);
  if (answers.count < 2) return;
  Settings used = as_recorded(settings, metadata, file);
  used.assemble.answer = answers.drawn == 1 ? 2 : 1;
  Trajectory poses =
      answer_trajectory(store, store.mission().footprint, used, console_progress(settings));
  const std::string run = fmt::format("{} alternative {}", name, used.assemble.answer);
  judged.runs.push_back({run, prepare(run, std::move(poses)), true_poses});
}

/// A store: both of its trajectories, and its plan.
void add_store(const Settings& settings, const Path& file, const std::string& name,
               const Truth& truth, const Preparation& prepare, Judged& judged) {
  const GeoPackageStore store(file, GeoPackageStore::Mode::read);
  Evaluation evaluation = evaluation_of(store, truth, prepare, settings.jobs);
  if (evaluation.missions) return add_missions(store, name, truth, prepare, evaluation, judged);
  PlacedMission placed = place(store, store.correction());
  const Trajectory true_poses = true_poses_of(store);
  judged.runs.push_back(
      {name + " odometry", prepare(name + " odometry", std::move(placed.odometry)), true_poses});
  judged.runs.push_back(
      {name + " corrected", prepare(name + " corrected", std::move(placed.corrected)), true_poses});
  add_other_answer(settings, file, name, true_poses, prepare, judged);
  evaluation.relations.reset();  // stand in the comparison
  evaluation.true_poses.reset();
  judged.plans.push_back({name, std::move(evaluation)});
}

/// A plan of another program; it is laid on the true one by its rooms.
void add_plan(const Settings& settings, const Path& file, const std::string& name,
              const Truth& truth, Judged& judged) {
  if (!truth.plan && truth.spans.empty()) {
    throw UsageError(file.string() +
                     ": a plan is judged by a true plan: give --truth PLAN.geojson or "
                     "--truth LABELS.pgm.gz, or --spans FILE.csv");
  }
  Truth of_plan;
  add_truth(file, settings, of_plan);
  const bool has_doors = of_plan.plan_has_doors;
  Truth against;
  against.plan = truth.plan;
  against.plan_has_doors = truth.plan_has_doors && has_doors;
  against.spans = truth.spans;
  judged.plans.push_back({name, roomatlas::evaluate({}, {}, *of_plan.plan, against)});
}

void add_run(const Settings& settings, const Path& file, const std::string& name,
             const Truth& truth, const Preparation& prepare, Judged& judged) {
  if (is_sqlite(file) && !is_recording(file)) {
    return add_store(settings, file, name, truth, prepare, judged);
  }
  if (is_plan(file)) return add_plan(settings, file, name, truth, judged);
  TrajectoryFile read = read_trajectory(file, settings.mission, LogPoses::recorded);
  show(read.issues);
  judged.runs.push_back({name, prepare(name, std::move(read.poses)), {}});
  judged.bare.push_back(file);
}

/// The last so many parts of a path.
Path end_of(const Path& file, std::ptrdiff_t parts) {
  const std::ptrdiff_t all = std::distance(file.begin(), file.end());
  Path end;
  for (auto part = std::next(file.begin(), std::max<std::ptrdiff_t>(0, all - parts));
       part != file.end(); ++part) {
    end /= *part;
  }
  return end;
}

/// The file's name, with as many of its folders as tell it from the others.
std::string name_of(const Path& file, const std::vector<Path>& all) {
  for (std::ptrdiff_t parts = 1; end_of(file, parts) != file; ++parts) {
    const auto same = std::count_if(all.begin(), all.end(), [&](const Path& other) {
      return end_of(other, parts) == end_of(file, parts);
    });
    if (same == 1) return end_of(file, parts).string();
  }
  return file.string();
}

Judged read(const Settings& settings, const std::vector<Path>& files, const Truth& truth,
            const Preparation& prepare) {
  Judged judged;
  for (const Path& file : files) {
    add_run(settings, file, name_of(file, files), truth, prepare, judged);
  }
  // Trajectories beside a simulated mission's store are of that mission.
  const auto with_truth = std::find_if(judged.runs.begin(), judged.runs.end(),
                                       [](const Run& run) { return !run.truth.empty(); });
  if (with_truth == judged.runs.end()) return judged;
  const Trajectory true_poses = with_truth->truth;
  for (Run& run : judged.runs) {
    if (run.truth.empty()) run.truth = true_poses;
  }
  return judged;
}

/// Whether there is anything to judge trajectories by.
bool has_truth(const Judged& judged, const Truth& truth) {
  return !truth.relations.empty() || !truth.poses.empty() ||
         std::any_of(judged.runs.begin(), judged.runs.end(),
                     [](const Run& run) { return !run.truth.empty() || !run.relations.empty(); });
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

/// Results replace none of the files that are read.
void require_places(const ComparisonFiles& results, std::vector<Path> inputs,
                    const std::vector<Path>& truth_files, const TrajectoryFlags& flags) {
  for (const Path& truth : truth_files) inputs.push_back(named_truth(truth).file);
  inputs.insert(inputs.end(), {flags.stamps_from, flags.carry});
  require_output_files({results.csv, results.latex, results.archive}, inputs);
}

void report(const Settings& settings, const Comparison& comparison,
            const std::vector<JudgedPlan>& plans, const Preparation& prepare) {
  if (settings.json) {
    fmt::print("{}", to_json(comparison, plans));
  } else {
    if (comparison.has_figures()) print(comparison, prepare.steps());
    if (plans.size() == 1) print(plans.front().evaluation);
    if (plans.size() > 1) print_side_by_side(plans);
  }
  for (const JudgedRun& run : comparison.runs) show(run.issues);
}

}  // namespace

Evaluation evaluation_of(const Settings& settings, const Path& store_file,
                         const std::vector<Path>& truth_files, const TrajectoryFlags& flags) {
  const GeoPackageStore store(store_file, GeoPackageStore::Mode::read);
  const Truth truth = read_truth(truth_files, settings);
  return evaluation_of(store, truth, Preparation(flags, settings), settings.jobs);
}

void evaluate(const Settings& settings, const std::vector<Path>& files,
              const std::vector<Path>& truth_files, const TrajectoryFlags& flags,
              const ComparisonFiles& results) {
  require_places(results, files, truth_files, flags);
  const Truth truth = read_truth(truth_files, settings);
  const Preparation prepare(flags, settings);
  const Judged judged = read(settings, files, truth, prepare);
  if (!judged.bare.empty() && !has_truth(judged, truth)) {
    throw UsageError(judged.bare.front().string() + kNoTruth);
  }
  std::string name = names_of(truth_files);
  if (truth.poses.empty() && truth.relations.empty() && has_truth(judged, truth)) {
    name += name.empty() ? kOwnTruth : std::string(", ") + kOwnTruth;
  }
  const Comparison comparison =
      compare(judged.runs, {name, truth.relations, truth.poses}, flags.compare, prepare.carry());
  if (!comparison.has_figures() && has_truth(judged, truth)) refuse(comparison);
  report(settings, comparison, judged.plans, prepare);
  write(comparison, judged.plans, results);
}

}  // namespace roomatlas::apps
