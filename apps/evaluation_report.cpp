// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation_report.hpp"

#include <fmt/format.h>

#include "console.hpp"
#include "plan_report.hpp"

namespace roomatlas::apps {
namespace {

void print_row(const char* subject, const char* when, const char* unit, const Statistics& errors) {
  if (errors.count == 0) return;
  fmt::print(
      "  {:<20} {:<8} {:>6}  mean {:>8.3f} {:<3}  std {:>8.3f}  median {:>8.3f}  max {:>8.3f}\n",
      subject, when, errors.count, errors.mean, unit, errors.standard_deviation, errors.median,
      errors.maximum);
}

void print_subset(const char* subject, const RelationSubset& before, const RelationSubset& after) {
  const std::string of(subject);
  print_row((of + " translation").c_str(), "odometry", "m", before.translation_m);
  print_row((of + " translation").c_str(), "corrected", "m", after.translation_m);
  print_row((of + " rotation").c_str(), "odometry", "deg", before.rotation_deg);
  print_row((of + " rotation").c_str(), "corrected", "deg", after.rotation_deg);
}

void print(const RelationsBeforeAfter& relations) {
  fmt::print("relations: {} of {} matched ({:.0f} %), {}\n", relations.after.matched,
             relations.after.relations, 100.0 * relations.after.coverage(),
             to_string(relations.after.use));
  print_subset("all", relations.before.all, relations.after.all);
  print_subset("local", relations.before.local, relations.after.local);
  print_subset("loop", relations.before.loop, relations.after.loop);
  show(relations.after.issues);
}

void print(const TruePosesBeforeAfter& poses) {
  fmt::print("true poses: {} of {} matched, aligned at the first\n", poses.after.matched,
             poses.after.poses);
  print_row("position", "odometry", "m", poses.before.position_m);
  print_row("position", "corrected", "m", poses.after.position_m);
  print_row("position, fitted", "odometry", "m", poses.before.fitted_position_m);
  print_row("position, fitted", "corrected", "m", poses.after.fitted_position_m);
  print_row("heading", "odometry", "deg", poses.before.heading_deg);
  print_row("heading", "corrected", "deg", poses.after.heading_deg);
}

}  // namespace

void print(const Evaluation& evaluation) {
  if (evaluation.relations) print(*evaluation.relations);
  if (evaluation.true_poses) print(*evaluation.true_poses);
  print_plan_evaluation(evaluation);
  show(evaluation.issues);
}

}  // namespace roomatlas::apps
