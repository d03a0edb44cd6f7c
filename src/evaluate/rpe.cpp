// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/ape_rpe.hpp"

#include "pose_relation.hpp"

#include <cmath>
#include <cstdio>

namespace roomatlas {
namespace {

double distance_between(const std::vector<Pose2>& poses, std::size_t from, std::size_t to) {
  return (poses[to].position() - poses[from].position()).norm();
}

void add_distance_error(const MatchedPoses& matched, std::size_t from, std::size_t to,
                        PoseRelation relation, PoseErrors& result) {
  const double truth_m = distance_between(matched.truth_from_robot, from, to);
  double error = std::abs(truth_m - distance_between(matched.estimate_from_robot, from, to));
  if (relation == PoseRelation::point_distance_error_ratio) {
    if (truth_m == 0.0) {
      ++result.zero_distances;
      return;
    }
    error *= 100.0 / truth_m;
  }
  result.errors.push_back(error);
  result.from.push_back(from);
  result.places.push_back(to);
}

/// inverse(true motion) * estimated motion, from one place to the other.
Pose2 error_between(const MatchedPoses& matched, std::size_t from, std::size_t to) {
  const Pose2 truth = inverse(matched.truth_from_robot[from]) * matched.truth_from_robot[to];
  const Pose2 estimate =
      inverse(matched.estimate_from_robot[from]) * matched.estimate_from_robot[to];
  return inverse(truth) * estimate;
}

}  // namespace

PoseErrors rpe(const MatchedPoses& matched, const RpeOptions& options) {
  PoseErrors result;
  const bool by_distance = options.relation == PoseRelation::point_distance ||
                           options.relation == PoseRelation::point_distance_error_ratio;
  const auto& measured =
      options.pairs_from_reference ? matched.truth_from_robot : matched.estimate_from_robot;
  for (const auto& [from, to] : delta_pairs(measured, options)) {
    if (by_distance) {
      add_distance_error(matched, from, to, options.relation, result);
      continue;
    }
    result.errors.push_back(
        evaluation::size_of(error_between(matched, from, to), options.relation));
    result.from.push_back(from);
    result.places.push_back(to);
  }
  result.statistics = statistics(result.errors);
  return result;
}

const char* to_string(DeltaUnit unit) {
  switch (unit) {
    case DeltaUnit::metres:
      return "m";
    case DeltaUnit::degrees:
      return "d";
    case DeltaUnit::radians:
      return "r";
    case DeltaUnit::frames:
      break;
  }
  return "f";
}

std::string title_of(const RpeOptions& options) {
  const std::string unit = unit_of(options.relation);
  const char* delta_unit = options.unit == DeltaUnit::frames    ? "frames"
                           : options.unit == DeltaUnit::metres  ? "m"
                           : options.unit == DeltaUnit::degrees ? "deg"
                                                                : "rad";
  char delta[64];
  std::snprintf(delta, sizeof delta, "%.6g", options.delta);
  return std::string("RPE w.r.t. ") + title_of(options.relation) + " (" +
         (unit.empty() ? "unit-less" : unit) + ")\nfor delta = " + delta + " (" + delta_unit +
         ") using " + (options.all_pairs ? "all" : "consecutive") + " pairs";
}

}  // namespace roomatlas
