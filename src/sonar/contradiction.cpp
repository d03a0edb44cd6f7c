// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/sonar/contradiction.hpp"

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

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
};

/// Samples of wall by cell.
class WallCells {
 public:
  explicit WallCells(double cell_m) : cell_m_(cell_m) {}

  void add(const WallSample& sample) {
    cells_[key(column(sample.point.x()), column(sample.point.y()))].push_back(samples_.size());
    samples_.push_back(sample);
  }
  [[nodiscard]] std::int64_t column(double at_m) const {
    return static_cast<std::int64_t>(std::floor(at_m / cell_m_));
  }
  /// Samples in a cell.
  [[nodiscard]] const std::vector<std::size_t>& in(std::int64_t x, std::int64_t y) const {
    static const std::vector<std::size_t> kNone;
    const auto found = cells_.find(key(x, y));
    return found == cells_.end() ? kNone : found->second;
  }
  [[nodiscard]] std::vector<WallSample>& samples() { return samples_; }

 private:
  [[nodiscard]] static std::int64_t key(std::int64_t x, std::int64_t y) {
    return x * (std::int64_t{1} << 32) + y;
  }
  double cell_m_;
  std::unordered_map<std::int64_t, std::vector<std::size_t>> cells_;  // looked up, never walked
  std::vector<WallSample> samples_;
};

void add_walls(std::span<const Pose2> map_from_robot, std::span<const double> path_m,
               std::span<const WallSegment> segments, const ContradictionOptions& options,
               WallCells& cells) {
  for (const WallSegment& segment : segments) {
    const Pose2& pose = map_from_robot[segment.reading];
    const Point2 normal = direction(pose.theta_rad + segment.normal_rad);
    const Point2 tangent(-normal.y(), normal.x());
    const Point2 middle = pose * segment.middle_robot;
    const int half = static_cast<int>(segment.length_m / 2.0 / options.sample_m);
    for (int step = -half; step <= half; ++step) {
      cells.add({middle + step * options.sample_m * tangent, normal, path_m[segment.reading], 0});
    }
  }
}

/// Lets the rays of one reading cross the walls of other visits.
void cross(const RangeReading& reading, const Pose2& map_from_robot, double path_m,
           const ContradictionOptions& options, WallCells& cells) {
  const RangeSensor& sensor = *reading.sensor;
  for (std::size_t i = 0; i < sensor.robot_from_beam.size(); ++i) {
    const double range_m = reading.ranges_m[i];
    if (!(range_m > 0.0 && range_m < std::min(sensor.max_range_m, options.max_range_m))) continue;
    const Pose2 beam = map_from_robot * sensor.robot_from_beam[i];
    const Point2 ahead = direction(beam.theta_rad);
    std::int64_t last_x = 0;
    std::int64_t last_y = 0;
    bool first = true;
    for (double at_m = 0.0; at_m < range_m - options.short_of_return_m;
         at_m += options.cell_m * kStepCells) {
      const Point2 point = beam.position() + at_m * ahead;
      const std::int64_t x = cells.column(point.x());
      const std::int64_t y = cells.column(point.y());
      if (!first && x == last_x && y == last_y) continue;
      first = false;
      last_x = x;
      last_y = y;
      for (const std::size_t s : cells.in(x, y)) {
        WallSample& sample = cells.samples()[s];
        if (std::abs(sample.path_m - path_m) > options.same_visit_m) ++sample.crossed;
      }
    }
  }
}

bool is_confirmed(const WallSample& sample, const WallCells& cells,
                  const std::vector<WallSample>& samples, const ContradictionOptions& options) {
  const std::int64_t x = cells.column(sample.point.x());
  const std::int64_t y = cells.column(sample.point.y());
  for (std::int64_t dx = -1; dx <= 1; ++dx) {
    for (std::int64_t dy = -1; dy <= 1; ++dy) {
      for (const std::size_t s : cells.in(x + dx, y + dy)) {
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
  WallCells cells(options.cell_m);
  add_walls(map_from_robot, path_m, segments, options, cells);
  double next_m = 0.0;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (path_m[i] < next_m || readings[i].sensor->kind != SensorKind::sonar) continue;
    next_m = path_m[i] + options.ray_step_m;
    cross(readings[i], map_from_robot[i], path_m[i], options, cells);
  }
  Contradiction result;
  for (const WallSample& sample : cells.samples()) {
    if (is_confirmed(sample, cells, cells.samples(), options)) {
      result.confirmed_m += options.sample_m;
    } else if (sample.crossed >= kEnoughRays) {
      result.contradicted_m += options.sample_m;
    }
  }
  return result;
}

}  // namespace roomatlas
