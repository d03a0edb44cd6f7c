// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/locate/query_rays.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace roomatlas {
namespace {

constexpr double kRoundingRad = 1e-6;  // beams so much nearer are as far apart as asked

void add_rays(const RangeReading& reading, const Pose2& query_from_robot,
              const QueryRayOptions& options, std::vector<QueryRay>& rays) {
  const RangeSensor& sensor = *reading.sensor;
  const bool is_laser = sensor.kind == SensorKind::laser;
  std::optional<double> last_rad;
  for (std::size_t i = 0; i < reading.ranges_m.size(); ++i) {
    const double range_m = reading.ranges_m[i];
    if (!(range_m > 0.0)) continue;  // NaN too
    const Pose2& robot_from_beam = sensor.robot_from_beam[i];
    const bool is_beside = last_rad && std::abs(wrap_angle(robot_from_beam.theta_rad - *last_rad)) <
                                           options.laser_every_rad - kRoundingRad;
    if (is_laser && is_beside) continue;
    last_rad = robot_from_beam.theta_rad;
    rays.push_back({query_from_robot * robot_from_beam, std::min(range_m, sensor.max_range_m),
                    is_laser ? 0.0 : sensor.half_cone_rad, range_m < sensor.max_range_m});
  }
}

}  // namespace

std::vector<QueryRay> rays_of(const Asr& asr, const QueryRayOptions& options) {
  std::vector<QueryRay> rays;
  std::optional<Point2> last;
  for (std::size_t i = 0; i < asr.path.size(); ++i) {
    const Pose2& asr_from_robot = asr.path[i].asr_from_robot;
    if (last && (asr_from_robot.position() - *last).norm() < options.every_m) continue;
    last = asr_from_robot.position();
    add_rays(asr.readings[i], asr_from_robot, options, rays);
  }
  return rays;
}

}  // namespace roomatlas
