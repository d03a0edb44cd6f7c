// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/relations.hpp"
#include "roomatlas/evaluate/time_ranges.hpp"

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

namespace roomatlas {
namespace {

constexpr std::int64_t kNamedIssues = 5;  ///< more would bury the count

/// Six decimals, as the files have them.
std::string text_of(double seconds) {
  char text[64];
  std::snprintf(text, sizeof text, "%.6f", seconds);
  return text;
}

/// What to do about a time without a pose.
std::string remedy_for(const MatchOptions& options) {
  if (options.match == TimeMatch::exact) {
    return "; give one pose for each range scan, stamped with the scan's own timestamp to the "
           "microsecond, or --match nearest";
  }
  return options.match == TimeMatch::nearest || options.max_gap_s
             ? "; a larger --max-gap reaches farther"
             : "; it is outside of the trajectory: --carry ODOMETRY reaches farther";
}

Issue name_unmatched(const Relation& relation, std::int64_t number, const PoseLookup& poses,
                     const MatchOptions& options) {
  std::string missing;
  for (const auto& [name, timestamp_s] : {std::pair{"t1", relation.t1_s}, {"t2", relation.t2_s}}) {
    if (poses.at(timestamp_s)) continue;
    const double nearest_s = poses.nearest_s(timestamp_s);
    missing += missing.empty() ? name : std::string(" and ") + name;
    if (std::isfinite(nearest_s)) missing += " (nearest " + text_of(nearest_s) + " s away)";
  }
  const std::string missing_and_remedy = missing + remedy_for(options);
  return {Severity::warning, "", 0, "relation " + std::to_string(number),
          "t1 = " + text_of(relation.t1_s) + ", t2 = " + text_of(relation.t2_s) +
              ": the trajectory has no pose at " + missing_and_remedy};
}

std::vector<double> times_of(const std::vector<Relation>& relations) {
  std::vector<double> times_s;
  for (const Relation& relation : relations) {
    times_s.push_back(relation.t1_s);
    times_s.push_back(relation.t2_s);
  }
  return times_s;
}

Issue count_unmatched(const RelationErrors& errors, const Trajectory& trajectory,
                      const std::vector<Relation>& relations) {
  const bool none = errors.matched == 0;
  const std::int64_t unmatched = errors.relations - errors.matched;
  return {none ? Severity::error : Severity::warning, "", 0, "relations",
          std::to_string(unmatched) + " of " + std::to_string(errors.relations) +
              " have no pose at one of their timestamps and do not count" +
              (none ? "; " + explain_mismatch(roomatlas::times_of(trajectory), times_of(relations))
                    : "")};
}

struct ErrorLists {
  std::vector<double> translation_m;
  std::vector<double> rotation_deg;

  void add(const RelationError& error) {
    translation_m.push_back(error.translation_m);
    rotation_deg.push_back(error.rotation_deg);
  }
  [[nodiscard]] RelationSubset summary() const {
    return {statistics(translation_m), statistics(rotation_deg)};
  }
};

void summarise(RelationErrors& result) {
  ErrorLists all;
  ErrorLists local;
  ErrorLists loop;
  for (const RelationError& error : result.errors) {
    all.add(error);
    (error.is_local ? local : loop).add(error);
  }
  result.all = all.summary();
  result.local = local.summary();
  result.loop = loop.summary();
}

}  // namespace

RelationErrors relation_errors(const Trajectory& trajectory, const std::vector<Relation>& relations,
                               const RelationOptions& options, const Trajectory* carry) {
  const PoseLookup poses(trajectory, options.match, carry);
  RelationErrors result;
  for (std::size_t i = 0; i < relations.size(); ++i) {
    const Relation& relation = relations[i];
    ++result.relations;
    const auto map_from_pose1 = poses.at(relation.t1_s);
    const auto map_from_pose2 = poses.at(relation.t2_s);
    if (!map_from_pose1 || !map_from_pose2) {
      if (std::ssize(result.issues) < kNamedIssues) {
        result.issues.push_back(name_unmatched(relation, result.relations, poses, options.match));
      }
      continue;
    }
    ++result.matched;
    count(result.use, *map_from_pose1);
    count(result.use, *map_from_pose2);
    const Pose2 pose1_from_pose2 = inverse(map_from_pose1->pose) * map_from_pose2->pose;
    const Pose2 error = inverse(relation.pose1_from_pose2) * pose1_from_pose2;
    result.errors.push_back({i, relation.t1_s, relation.t2_s, error.position().norm(),
                             degrees(std::abs(error.theta_rad)),
                             std::abs(relation.t2_s - relation.t1_s) < options.split_s,
                             map_from_pose2->pose});
  }
  if (result.matched < result.relations) {
    result.issues.insert(result.issues.begin(), count_unmatched(result, trajectory, relations));
  }
  summarise(result);
  return result;
}

}  // namespace roomatlas
