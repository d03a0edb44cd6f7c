// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/trajectories/evo_archive.hpp"

#include <algorithm>
#include <stdexcept>

namespace roomatlas {
namespace {

/// Distance along the path up to each pose.
std::vector<double> distances_of(const Trajectory& trajectory) {
  std::vector<double> distances_m(trajectory.size(), 0.0);
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    distances_m[i] = distances_m[i - 1] +
                     (trajectory[i].pose.position() - trajectory[i - 1].pose.position()).norm();
  }
  return distances_m;
}

std::vector<double> since(const std::vector<double>& times_s, double start_s) {
  std::vector<double> seconds = times_s;
  for (double& second : seconds) second -= start_s;
  return seconds;
}

std::string file_name_of(std::string name) {
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

std::string label_of(const char* metric, PoseRelation relation) {
  const std::string unit = unit_of(relation);
  return std::string(metric) + " (" + (unit.empty() ? "unit-less" : unit) + ")";
}

const JudgedPoses& poses_of(const JudgedRun& run) {
  if (!run.true_poses) throw std::invalid_argument("the run was not compared with true poses");
  return *run.true_poses;
}

/// The names stand for the trajectories, so they must differ.
EvoResult named_result(const JudgedRun& run, const Comparison& comparison) {
  EvoResult result;
  result.ref_name = file_name_of(comparison.truth);
  result.est_name = file_name_of(run.name);
  if (result.ref_name == result.est_name) result.ref_name += "_truth";
  return result;
}

/// Trajectories at the given places, and what evo derives from them, beginning at `first_value`.
void add_trajectories(EvoResult& result, const MatchedPoses& matched,
                      const std::vector<std::size_t>& places, const Pose2& truth_from_estimate,
                      std::size_t first_value) {
  Trajectory truth;
  Trajectory estimate;
  std::vector<double> times_s;
  for (const std::size_t place : places) {
    const double time_s = matched.timestamps_s[place];
    times_s.push_back(time_s);
    truth.push_back({time_s, matched.truth_from_robot[place]});
    estimate.push_back({time_s, truth_from_estimate * matched.estimate_from_robot[place]});
  }
  const auto add = [&](const char* name, std::vector<double> values) {
    values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(first_value));
    result.arrays.emplace_back(name, std::move(values));
  };
  add("seconds_from_start", since(times_s, times_s.front()));
  add("timestamps", times_s);
  add("distances_from_start", distances_of(truth));
  add("distances", distances_of(estimate));
  result.trajectories = {{result.ref_name, truth}, {result.est_name, estimate}};
}

}  // namespace

EvoResult evo_ape(const JudgedRun& run, const Comparison& comparison) {
  const JudgedPoses& judged = poses_of(run);
  EvoResult result = named_result(run, comparison);
  result.title = title_of(comparison.options.ape);
  result.label = label_of("APE", comparison.options.ape.relation);
  result.statistics = judged.ape.statistics;
  result.arrays.emplace_back("error_array", judged.ape.errors);
  result.aligned = comparison.options.ape.alignment != Alignment::none;
  result.truth_from_estimate = judged.ape.truth_from_estimate;
  add_trajectories(result, judged.matched, judged.ape.places, result.truth_from_estimate, 0);
  return result;
}

EvoResult evo_rpe(const JudgedRun& run, const Comparison& comparison) {
  const JudgedPoses& judged = poses_of(run);
  EvoResult result = named_result(run, comparison);
  result.title = title_of(comparison.options.rpe) + "\n(not aligned)";
  result.label = label_of("RPE", comparison.options.rpe.relation);
  result.statistics = judged.rpe.statistics;
  result.arrays.emplace_back("error_array", judged.rpe.errors);
  std::vector<std::size_t> places = {0};
  places.insert(places.end(), judged.rpe.places.begin(), judged.rpe.places.end());
  add_trajectories(result, judged.matched, places, {}, 1);
  return result;
}

EvoResult evo_relations(const JudgedRun& run, const Comparison& comparison) {
  if (!run.relations) throw std::invalid_argument("the run was not compared with relations");
  const RelationErrors& errors = run.relations->errors;
  EvoResult result = named_result(run, comparison);
  result.title = "Relations, translation (m)\n(" +
                 describe(comparison.options.match, comparison.carried) + ")";
  result.label = "relations (m)";
  result.statistics = errors.all.translation_m;
  std::vector<double> translation_m;
  std::vector<double> times_s;
  double start_s = errors.errors.empty() ? 0.0 : errors.errors.front().t2_s;
  for (const RelationError& error : errors.errors) {
    translation_m.push_back(error.translation_m);
    times_s.push_back(error.t2_s);
    start_s = std::min(start_s, error.t2_s);
  }
  result.arrays = {{"error_array", translation_m},
                   {"seconds_from_start", since(times_s, start_s)},
                   {"timestamps", times_s}};
  return result;
}

}  // namespace roomatlas
