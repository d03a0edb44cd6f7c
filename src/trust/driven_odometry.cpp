// SPDX-License-Identifier: GPL-3.0-or-later
#include "driven_odometry.hpp"

#include <cmath>

namespace roomatlas {
namespace {

constexpr double kStretch_m = 1.0;

}  // namespace

void OdometryUse::add(const std::vector<PathSample>& path) {
  double map_m = 0.0;
  double odometry_m = 0.0;
  double map_rad = 0.0;
  double odometry_rad = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Pose2 map = inverse(path[i - 1].asr_from_robot) * path[i].asr_from_robot;
    const Pose2 odometry = inverse(path[i - 1].odom_from_robot) * path[i].odom_from_robot;
    map_m += map.position().norm();
    odometry_m += odometry.position().norm();
    map_rad += map.theta_rad;
    odometry_rad += odometry.theta_rad;
    if (map_m < kStretch_m) continue;
    path_m_ += map_m;
    stretches_ += 1.0;
    const double heading_rad = wrap_angle(map_rad - odometry_rad) / map_m;
    heading_rad_ += heading_rad;
    heading_rad2_ += heading_rad * heading_rad;
    const double share = (odometry_m - map_m) / map_m;
    length2_ += share * share;
    map_m = odometry_m = map_rad = odometry_rad = 0.0;
  }
  path_m_ += map_m;
}

OdometryUse::Differences OdometryUse::differences() const {
  if (stretches_ == 0.0) return {};
  const double drift = heading_rad_ / stretches_;
  return {std::sqrt(std::max(0.0, heading_rad2_ / stretches_ - drift * drift)), drift,
          std::sqrt(length2_ / stretches_)};
}

}  // namespace roomatlas
