// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/loops/closures.hpp"

#include <cmath>
#include <limits>

namespace roomatlas {
namespace {

constexpr double kPathStepM = 0.4;  // of thinned paths: larger blurs distances, smaller costs time

}  // namespace

const char* to_string(ClosureVerdict verdict) {
  switch (verdict) {
    case ClosureVerdict::accepted:
      return "accepted";
    case ClosureVerdict::too_little_in_common:
      return "too little in common";
    case ClosureVerdict::contradicted:
      return "contradicted by readings";
    case ClosureVerdict::left_out:
      return "left out as asked";
  }
  return "unknown";
}

ClosureVerdict judge(const MapMatch& match, int min_agreeing, double min_agreement) {
  if (match.agreeing < min_agreeing) return ClosureVerdict::too_little_in_common;
  return match.agreement() < min_agreement ? ClosureVerdict::contradicted
                                           : ClosureVerdict::accepted;
}

AsrShape shape_of(const Asr& asr, const LocalizeOptions& localize, const MatchMapsOptions& match) {
  AsrShape shape;
  shape.id = asr.id;
  shape.map = LocalMap(localize.cell_m);
  std::optional<Pose2> last_added;
  MovingPoints moving(localize.moving);
  RecentSweeps recent(localize.recent);
  for (std::size_t i = 0; i < asr.readings.size(); ++i) {
    const Pose2& pose = asr.path[i].asr_from_robot;
    if (shape.path.empty() || (shape.path.back() - pose.position()).norm() > kPathStepM) {
      shape.path.push_back(pose.position());
    }
    if (!can_be_matched(asr.readings[i])) continue;
    const bool has_few_beams = recent.are_needed(*asr.readings[i].sensor);
    if (last_added && !is_new_view(*last_added, pose, localize, has_few_beams)) continue;
    last_added = pose;
    Scan scan = scan_of(asr.readings[i], localize.scan);
    moving.hide(scan, asr.readings[i].timestamp_s, asr.readings[i].odom_from_robot, pose);
    if (has_few_beams) {
      recent.add_normals(scan, pose);
      recent.add(scan, pose);
    }
    shape.map.add(scan, pose);
  }
  shape.points = points_of(shape.map, match);
  return shape;
}

double path_distance_m(const AsrShape& first, const AsrShape& second,
                       const Pose2& first_from_second) {
  double least = std::numeric_limits<double>::infinity();
  for (const Point2& q : second.path) {
    const Point2 at = first_from_second * q;
    for (const Point2& p : first.path) least = std::min(least, (p - at).squaredNorm());
  }
  return std::sqrt(least);
}

}  // namespace roomatlas
