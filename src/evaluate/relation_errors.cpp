// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <unordered_map>

#include "roomatlas/evaluate/relations.hpp"

namespace roomatlas {
namespace {

constexpr std::int64_t kNamedIssues = 5;  ///< more would bury the count

/// Whole microseconds: two timestamps are equal when these are. Nothing for a timestamp that is
/// not finite or too large for the integer.
std::optional<std::int64_t> microseconds(double timestamp_s) {
  constexpr double kLimit_s = 9e12;
  if (!(std::abs(timestamp_s) < kLimit_s)) return std::nullopt;
  return std::llround(timestamp_s * 1e6);
}

/// Poses by timestamp; times may step back, and the first of equal ones holds.
class PoseIndex {
 public:
  explicit PoseIndex(const Trajectory& trajectory) : trajectory_(trajectory) {
    poses_.reserve(trajectory.size());
    for (const StampedPose& stamped : trajectory) {
      if (const auto key = microseconds(stamped.timestamp_s)) {
        poses_.try_emplace(*key, &stamped.pose);
      }
    }
  }

  /// The pose at a timestamp, or null.
  [[nodiscard]] const Pose2* at(double timestamp_s) const {
    const auto key = microseconds(timestamp_s);
    if (!key) return nullptr;
    const auto found = poses_.find(*key);
    return found == poses_.end() ? nullptr : found->second;
  }

  /// Seconds to the nearest pose in time; infinity without poses. Looks at all of them.
  [[nodiscard]] double nearest_s(double timestamp_s) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const StampedPose& stamped : trajectory_) {
      nearest = std::fmin(nearest, std::abs(stamped.timestamp_s - timestamp_s));
    }
    return nearest;
  }

 private:
  const Trajectory& trajectory_;
  std::unordered_map<std::int64_t, const Pose2*> poses_;
};

/// Six decimals, as the files have them.
std::string text_of(double seconds) {
  char text[64];
  std::snprintf(text, sizeof text, "%.6f", seconds);
  return text;
}

Issue name_unmatched(const Relation& relation, std::int64_t number, const PoseIndex& poses) {
  std::string missing;
  for (const auto& [name, timestamp_s] : {std::pair{"t1", relation.t1_s}, {"t2", relation.t2_s}}) {
    if (poses.at(timestamp_s) != nullptr) continue;
    const double nearest_s = poses.nearest_s(timestamp_s);
    missing += missing.empty() ? name : std::string(" and ") + name;
    if (std::isfinite(nearest_s)) missing += " (nearest " + text_of(nearest_s) + " s away)";
  }
  return {Severity::warning, "", 0, "relation " + std::to_string(number),
          "t1 = " + text_of(relation.t1_s) + ", t2 = " + text_of(relation.t2_s) +
              ": the trajectory has no pose at " + missing +
              "; give one pose for each range scan, stamped with the scan's own timestamp to the "
              "microsecond"};
}

Issue count_unmatched(std::int64_t unmatched, std::int64_t relations) {
  const bool none = unmatched == relations;
  return {none ? Severity::error : Severity::warning, "", 0, "relations",
          std::to_string(unmatched) + " of " + std::to_string(relations) +
              " have no pose at one of their timestamps and do not count" +
              (none ? "; are relations and trajectory from the same log?" : "")};
}

struct ErrorLists {
  std::vector<double> translation_m;
  std::vector<double> rotation_deg;

  void add(const Pose2& error) {
    translation_m.push_back(error.position().norm());
    rotation_deg.push_back(degrees(std::abs(error.theta_rad)));
  }
  [[nodiscard]] RelationSubset summary() const {
    return {statistics(translation_m), statistics(rotation_deg)};
  }
};

}  // namespace

RelationErrors relation_errors(const Trajectory& trajectory, const std::vector<Relation>& relations,
                               const RelationOptions& options) {
  const PoseIndex poses(trajectory);
  RelationErrors result;
  ErrorLists all;
  ErrorLists local;
  ErrorLists loop;
  for (const Relation& relation : relations) {
    ++result.relations;
    const Pose2* map_from_pose1 = poses.at(relation.t1_s);
    const Pose2* map_from_pose2 = poses.at(relation.t2_s);
    if (map_from_pose1 == nullptr || map_from_pose2 == nullptr) {
      if (std::ssize(result.issues) < kNamedIssues) {
        result.issues.push_back(name_unmatched(relation, result.relations, poses));
      }
      continue;
    }
    ++result.matched;
    const Pose2 pose1_from_pose2 = inverse(*map_from_pose1) * *map_from_pose2;
    const Pose2 error = inverse(relation.pose1_from_pose2) * pose1_from_pose2;
    all.add(error);
    (std::abs(relation.t2_s - relation.t1_s) < options.split_s ? local : loop).add(error);
  }
  if (const std::int64_t unmatched = result.relations - result.matched; unmatched > 0) {
    result.issues.insert(result.issues.begin(), count_unmatched(unmatched, result.relations));
  }
  result.all = all.summary();
  result.local = local.summary();
  result.loop = loop.summary();
  return result;
}

}  // namespace roomatlas
