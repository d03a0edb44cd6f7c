// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/sonar/contradiction.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "square_index.hpp"

namespace roomatlas {
namespace {

constexpr double kStepCells = 0.7;    // along a ray: a larger step leaps over corners of cells
constexpr double kCosSameWay = 0.87;  // 30 degrees: faces that look elsewhere are other walls
constexpr int kEnoughRays = 2;        // one may be a stray echo

struct WallSample {
  Point2 point;
  Point2 normal;
  double path_m = 0.0;
  int crossed = 0;  ///< by rays of other visits
  std::size_t reading = 0;
};

/// Of the cells in which they lie.
SquareIndex cells_of(const std::vector<WallSample>& samples, const ContradictionOptions& options) {
  std::vector<SquareIndex::Entry> entries;
  entries.reserve(samples.size());
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    entries.push_back({square_of(samples[i].point, options.cell_m), i});
  }
  return SquareIndex(entries);
}

std::vector<WallSample> samples_of(std::span<const Pose2> map_from_robot,
                                   std::span<const double> path_m,
                                   std::span<const WallSegment> segments,
                                   const ContradictionOptions& options) {
  std::vector<WallSample> samples;
  for (const WallSegment& segment : segments) {
    const Pose2& pose = map_from_robot[segment.reading];
    const Point2 normal = direction(pose.theta_rad + segment.normal_rad);
    const Point2 tangent(-normal.y(), normal.x());
    const Point2 middle = pose * segment.middle_robot;
    const int half = static_cast<int>(segment.length_m / 2.0 / options.sample_m);
    for (int step = -half; step <= half; ++step) {
      samples.push_back({middle + step * options.sample_m * tangent, normal,
                         path_m[segment.reading], 0, segment.reading});
    }
  }
  return samples;
}

/// Lets the rays of one reading cross the walls of other visits.
void cross(const RangeReading& reading, const Pose2& map_from_robot, double path_m,
           const ContradictionOptions& options, const SquareIndex& cells,
           std::vector<WallSample>& samples) {
  const RangeSensor& sensor = *reading.sensor;
  const PointTransform place(map_from_robot);
  for (std::size_t i = 0; i < sensor.robot_from_beam.size(); ++i) {
    const double range_m = reading.ranges_m[i];
    if (!(range_m > 0.0 && range_m < std::min(sensor.max_range_m, options.max_range_m))) continue;
    const Pose2 beam = place.pose(map_from_robot, sensor.robot_from_beam[i]);
    const Point2 ahead = direction(beam.theta_rad);
    std::optional<Square> last;
    for (double at_m = 0.0; at_m < range_m - options.short_of_return_m;
         at_m += options.cell_m * kStepCells) {
      const Square cell = square_of(beam.position() + at_m * ahead, options.cell_m);
      if (last == cell) continue;
      last = cell;
      for (const std::uint32_t s : cells.at(cell)) {
        WallSample& sample = samples[s];
        if (std::abs(sample.path_m - path_m) > options.same_visit_m) ++sample.crossed;
      }
    }
  }
}

bool is_confirmed(const WallSample& sample, const SquareIndex& cells,
                  const std::vector<WallSample>& samples, const ContradictionOptions& options) {
  const Square cell = square_of(sample.point, options.cell_m);
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (const std::uint32_t s : cells.at({cell.x + dx, cell.y + dy})) {
        if (std::abs(samples[s].path_m - sample.path_m) > options.same_visit_m &&
            samples[s].normal.dot(sample.normal) > kCosSameWay) {
          return true;
        }
      }
    }
  }
  return false;
}

}  // namespace

Contradiction contradiction_of(std::span<const RangeReading> readings,
                               std::span<const Pose2> map_from_robot,
                               std::span<const double> path_m,
                               std::span<const WallSegment> segments,
                               const ContradictionOptions& options) {
  std::vector<WallSample> samples = samples_of(map_from_robot, path_m, segments, options);
  const SquareIndex cells = cells_of(samples, options);
  double next_m = 0.0;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (path_m[i] < next_m || readings[i].sensor->kind != SensorKind::sonar) continue;
    next_m = path_m[i] + options.ray_step_m;
    cross(readings[i], map_from_robot[i], path_m[i], options, cells, samples);
  }
  Contradiction result;
  result.confirmed_of_reading_m.assign(readings.size(), 0.0);
  result.contradicted_of_reading_m.assign(readings.size(), 0.0);
  for (const WallSample& sample : samples) {
    if (is_confirmed(sample, cells, samples, options)) {
      result.confirmed_m += options.sample_m;
      result.confirmed_of_reading_m[sample.reading] += options.sample_m;
    } else if (sample.crossed >= kEnoughRays) {
      result.contradicted_m += options.sample_m;
      result.contradicted_of_reading_m[sample.reading] += options.sample_m;
    }
  }
  return result;
}

}  // namespace roomatlas
