// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/compare.hpp"

#include "roomatlas/evaluate/time_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace roomatlas {
namespace {

/// Errors by what they are errors of: a relation's place, or a pose's time with its order.
using Keyed = std::map<std::pair<double, double>, double>;

/// This run's errors less the first run's, in this run's order, where both have one.
std::vector<double> differences(const std::vector<std::pair<double, double>>& keys,
                                const std::vector<double>& errors, const Keyed& first) {
  std::vector<double> result;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto found = first.find(keys[i]);
    if (found != first.end()) result.push_back(errors[i] - found->second);
  }
  return result;
}

/// Judges one list of errors, and remembers it when it is the first run's.
class Judge {
 public:
  explicit Judge(const BootstrapOptions& options) : options_(options) {}

  /// @param is_comparable false for a run of another mission than the first's
  JudgedErrors operator()(const std::vector<std::pair<double, double>>& keys,
                          const std::vector<double>& errors, bool is_comparable = true) {
    JudgedErrors judged;
    judged.statistics = statistics(errors);
    judged.interval = bootstrap_mean(errors, options_);
    if (first_ && !is_comparable) {
      judged.shared = 0;
    } else if (first_) {
      const std::vector<double> less = differences(keys, errors, *first_);
      judged.shared = std::ssize(less);
      judged.against_first = bootstrap_mean(less, options_);
    } else {
      first_.emplace();
      for (std::size_t i = 0; i < keys.size(); ++i) first_->emplace(keys[i], errors[i]);
      judged.shared = std::ssize(errors);
    }
    return judged;
  }

 private:
  BootstrapOptions options_;
  std::optional<Keyed> first_;
};

struct Judges {
  explicit Judges(const BootstrapOptions& options)
      : translation(options), rotation(options), ape(options), rpe(options) {}
  Judge translation, rotation, ape, rpe;
  const Trajectory* first_truth = nullptr;  ///< of the first run that has poses to be judged by
};

/// Whether two lists of true poses tell of one mission.
bool is_same(const Trajectory& a, const Trajectory& b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](const StampedPose& x, const StampedPose& y) {
           return x.timestamp_s == y.timestamp_s && x.pose.x_m == y.pose.x_m &&
                  x.pose.y_m == y.pose.y_m && x.pose.theta_rad == y.pose.theta_rad;
         });
}

JudgedRelations judge_relations(RelationErrors errors, Judges& judges) {
  std::vector<std::pair<double, double>> keys;
  std::vector<double> translation_m;
  std::vector<double> rotation_deg;
  for (const RelationError& error : errors.errors) {
    keys.emplace_back(static_cast<double>(error.relation), 0.0);
    translation_m.push_back(error.translation_m);
    rotation_deg.push_back(error.rotation_deg);
  }
  JudgedRelations judged{std::move(errors), judges.translation(keys, translation_m),
                         judges.rotation(keys, rotation_deg)};
  return judged;
}

JudgedPoses judge_poses(MatchedPoses matched, const CompareOptions& options, bool is_comparable,
                        Judges& judges) {
  JudgedPoses judged;
  judged.ape = ape(matched, options.ape);
  judged.rpe = rpe(matched, options.rpe);
  const auto keys_of = [&](const PoseErrors& errors) {
    std::vector<std::pair<double, double>> keys;
    for (std::size_t i = 0; i < errors.places.size(); ++i) {
      const double from_s = errors.from.empty() ? 0.0 : matched.timestamps_s[errors.from[i]];
      keys.emplace_back(from_s, matched.timestamps_s[errors.places[i]]);
    }
    return keys;
  };
  judged.ape_judged = judges.ape(keys_of(judged.ape), judged.ape.errors, is_comparable);
  judged.rpe_judged = judges.rpe(keys_of(judged.rpe), judged.rpe.errors, is_comparable);
  judged.matched = std::move(matched);
  return judged;
}

void note_poses(const JudgedPoses& judged, const Run& run, const Trajectory& truth,
                Issues& issues) {
  const std::size_t matched = judged.matched.size();
  if (matched == 0) {
    issues.push_back({Severity::error, run.name, 0, "true poses",
                      explain_mismatch(times_of(run.trajectory), times_of(truth))});
  } else if (matched == 1) {
    issues.push_back({Severity::warning, run.name, 0, "true poses",
                      "one pose only has a true one: alignment makes its error 0, and there is no "
                      "motion to judge; --match interpolate or a larger --max-gap finds more"});
  } else if (judged.rpe.errors.empty()) {
    issues.push_back({Severity::warning, run.name, 0, "RPE",
                      "no two of the " + std::to_string(matched) +
                          " matched poses are --delta apart: choose a smaller --delta or a larger "
                          "--delta-tol"});
  }
}

const Trajectory& poses_for(const Run& run, const TrajectoryTruth& truth) {
  return truth.poses.empty() ? run.truth : truth.poses;
}

const std::vector<Relation>& relations_for(const Run& run, const TrajectoryTruth& truth) {
  return run.relations.empty() ? truth.relations : run.relations;
}

JudgedRun judge(const Run& run, const TrajectoryTruth& truth, const CompareOptions& options,
                const Trajectory* carry, Judges& judges) {
  JudgedRun judged;
  judged.name = run.name;
  judged.poses = std::ssize(run.trajectory);
  judged.issues = check_trajectory(run.trajectory, run.name);
  const std::vector<Relation>& relations = relations_for(run, truth);
  if (!relations.empty()) {
    RelationErrors errors =
        relation_errors(run.trajectory, relations, {options.split_s, options.match}, carry);
    for (Issue issue : errors.issues) {
      issue.file = run.name;
      judged.issues.push_back(std::move(issue));
    }
    if (errors.matched > 0) judged.relations = judge_relations(std::move(errors), judges);
  }
  const Trajectory& true_poses = poses_for(run, truth);
  judged.truth_poses = std::ssize(true_poses);
  if (!true_poses.empty()) {
    if (judges.first_truth == nullptr) judges.first_truth = &true_poses;
    JudgedPoses poses = judge_poses(match_poses(run.trajectory, true_poses, options.match, carry),
                                    options, is_same(true_poses, *judges.first_truth), judges);
    note_poses(poses, run, true_poses, judged.issues);
    if (poses.matched.size() > 0) judged.true_poses = std::move(poses);
  }
  return judged;
}

}  // namespace

bool Comparison::has_figures() const {
  for (const JudgedRun& run : runs) {
    if (run.relations || run.true_poses) return true;
  }
  return false;
}

Comparison compare(const std::vector<Run>& runs, const TrajectoryTruth& truth,
                   const CompareOptions& options, const Trajectory* carry) {
  Comparison comparison;
  comparison.truth = truth.name;
  comparison.options = options;
  comparison.carried = carry != nullptr;
  comparison.relations = std::ssize(truth.relations);
  for (const Run& run : runs) {
    if (comparison.relations == 0) comparison.relations = std::ssize(run.relations);
    if (comparison.true_poses == 0) comparison.true_poses = std::ssize(poses_for(run, truth));
  }
  Judges judges(options.bootstrap);
  for (const Run& run : runs) comparison.runs.push_back(judge(run, truth, options, carry, judges));
  return comparison;
}

std::string describe(const MatchOptions& options, bool carried) {
  const double gap_s = max_gap_s(options, carried);
  char gap[48];
  std::snprintf(gap, sizeof gap, "%.3g s", gap_s);
  std::string text;
  switch (options.match) {
    case TimeMatch::exact:
      text = "equal to the microsecond";
      break;
    case TimeMatch::nearest:
      text = std::string("nearest pose within ") + gap;
      break;
    case TimeMatch::interpolate:
      text = "interpolated linearly across gaps of ";
      text += std::isinf(gap_s) ? std::string("any length") : std::string("up to ") + gap;
      break;
  }
  if (!carried) return text;
  return (gap_s == 0.0 ? std::string("equal to the microsecond") : text) +
         ", else carried on from the pose before by odometry";
}

}  // namespace roomatlas
