// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/ape_rpe.hpp"

#include "pose_relation.hpp"

#include <stdexcept>

namespace roomatlas {

PoseErrors ape(const MatchedPoses& matched, const ApeOptions& options) {
  if (options.relation == PoseRelation::point_distance_error_ratio) {
    throw std::invalid_argument("an absolute error has no distance to take a ratio of");
  }
  PoseErrors result;
  result.truth_from_estimate =
      truth_from_estimate(matched, options.alignment, options.poses_to_align);
  for (std::size_t i = 0; i < matched.size(); ++i) {
    const Pose2 aligned = result.truth_from_estimate * matched.estimate_from_robot[i];
    const Pose2 error = inverse(aligned) * matched.truth_from_robot[i];
    result.errors.push_back(evaluation::size_of(error, options.relation));
    result.places.push_back(i);
  }
  result.statistics = statistics(result.errors);
  return result;
}

std::string title_of(const ApeOptions& options) {
  std::string title = std::string("APE w.r.t. ") + title_of(options.relation);
  const std::string unit = unit_of(options.relation);
  title += " (" + (unit.empty() ? "unit-less" : unit) + ")\n";
  switch (options.alignment) {
    case Alignment::none:
      return title + "(not aligned)";
    case Alignment::origin:
      return title + "(with origin alignment)";
    case Alignment::umeyama:
      break;
  }
  title += "(with SE(2) Umeyama alignment)";
  if (options.poses_to_align >= 0) {
    title += " (aligned poses: " + std::to_string(options.poses_to_align) + ")";
  }
  return title;
}

}  // namespace roomatlas
