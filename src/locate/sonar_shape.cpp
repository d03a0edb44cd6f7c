// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/locate/sonar_shape.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr double kHits = 4.0;       // of a stretch of wall: it was heard so often at least
constexpr double kPathStepM = 0.4;  // of a thinned path

std::vector<Pose2> poses_of(const Asr& asr) {
  std::vector<Pose2> poses;
  for (const PathSample& sample : asr.path) poses.push_back(sample.asr_from_robot);
  return poses;
}

std::vector<double> way_of(const std::vector<Pose2>& poses) {
  std::vector<double> way_m;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double step_m = i == 0 ? 0.0 : (poses[i].position() - poses[i - 1].position()).norm();
    way_m.push_back(i == 0 ? 0.0 : way_m.back() + step_m);
  }
  return way_m;
}

void add_wall(const WallSegment& segment, const Pose2& asr_from_robot, double sample_m,
              LocalMap& map) {
  const double normal_rad = segment.normal_rad + asr_from_robot.theta_rad;
  const Point2 middle = asr_from_robot * segment.middle_robot;
  const Point2 to_robot = -direction(normal_rad);
  const Point2 along{-to_robot.y(), to_robot.x()};
  const int half = static_cast<int>(segment.length_m / 2.0 / sample_m);
  for (int n = -half; n <= half; ++n) {
    map.add(Face{middle + n * sample_m * along, to_robot, kHits});
  }
}

/// The rays of one reading as free floor, nothing more. One scan a beam: each has its own origin.
void add_floor(const RangeReading& reading, const Pose2& asr_from_robot,
               const SonarShapeOptions& options, LocalMap& map) {
  const RangeSensor& sensor = *reading.sensor;
  for (std::size_t i = 0; i < reading.ranges_m.size(); ++i) {
    const double range_m = reading.ranges_m[i];
    if (!(range_m > options.short_of_echo_m)) continue;  // NaN too
    if (range_m > options.free_range_m || range_m >= sensor.max_range_m) continue;
    const Pose2& beam = sensor.robot_from_beam[i];
    Scan scan;
    scan.sensor = beam.position();
    scan.points.push_back(
        {beam * Point2{range_m - options.short_of_echo_m, 0.0}, Point2::Zero(), false});
    map.add(scan, asr_from_robot);
  }
}

}  // namespace

AsrShape sonar_shape_of(const Asr& asr, const SonarShapeOptions& options) {
  AsrShape shape;
  shape.id = asr.id;
  shape.map = LocalMap(options.cell_m);
  const std::vector<Pose2> poses = poses_of(asr);
  std::optional<Point2> freed_at;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Point2 at = poses[i].position();
    if (shape.path.empty() || (shape.path.back() - at).norm() > kPathStepM) {
      shape.path.push_back(at);
    }
    if (asr.readings[i].sensor->kind != SensorKind::sonar) continue;
    if (freed_at && (*freed_at - at).norm() < options.every_m) continue;
    freed_at = at;
    add_floor(asr.readings[i], poses[i], options, shape.map);
  }
  for (const WallSegment& segment :
       wall_segments(asr.readings, poses, way_of(poses), options.segments)) {
    add_wall(segment, poses[segment.reading], options.sample_m, shape.map);
  }
  shape.points = points_of(shape.map, MatchMapsOptions{});
  return shape;
}

}  // namespace roomatlas
