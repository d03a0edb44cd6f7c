// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/grid/himm_grid.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr int kGrowthCells = 32;  ///< margin added when the grid grows, so that it grows rarely

CellBox grown_to(const CellBox& box, const Cell& cell) {
  if (box.count() == 0) {
    return {{cell.x - kGrowthCells, cell.y - kGrowthCells},
            {cell.x + kGrowthCells, cell.y + kGrowthCells}};
  }
  CellBox grown = box;
  if (cell.x < box.min.x) grown.min.x = cell.x - kGrowthCells;
  if (cell.y < box.min.y) grown.min.y = cell.y - kGrowthCells;
  if (cell.x >= box.max.x) grown.max.x = cell.x + 1 + kGrowthCells;
  if (cell.y >= box.max.y) grown.max.y = cell.y + 1 + kGrowthCells;
  return grown;
}

}  // namespace

double HimmGrid::value(const Cell& cell) const {
  const std::int8_t stored = raw(cell);
  return stored == kRobotPath ? kMinHalfSteps / 2.0 : stored / 2.0;
}

void HimmGrid::cover(const Cell& cell) {
  if (box_.contains(cell)) return;
  const CellBox grown = grown_to(box_, cell);
  std::vector<std::int8_t> cells(grown.count(), std::int8_t{0});
  for (int y = box_.min.y; y < box_.max.y; ++y) {
    const auto row = cells_.begin() + static_cast<std::ptrdiff_t>(box_.index_of({box_.min.x, y}));
    std::copy(row, row + box_.width(),
              cells.begin() + static_cast<std::ptrdiff_t>(grown.index_of({box_.min.x, y})));
  }
  cells_ = std::move(cells);
  box_ = grown;
}

void HimmGrid::add(const Cell& cell, int half_steps) {
  std::int8_t& stored = cells_[box_.index_of(cell)];
  if (stored == kRobotPath) return;
  stored = static_cast<std::int8_t>(std::clamp(stored + half_steps, kMinHalfSteps, kMaxHalfSteps));
}

void HimmGrid::add_sweep(const std::vector<Ray>& rays) {
  for (const Ray& ray : rays) {
    const Cell from = frame_.cell_of(ray.segment.a);
    const Cell to = frame_.cell_of(ray.segment.b);
    cover(from);
    cover({to.x - 1, to.y - 1});
    cover({to.x + 1, to.y + 1});
    const auto pass = [&](const Cell& cell) {
      add(cell, kFreeHalfSteps);
      return true;
    };
    for_each_cell_on_line(from, to, pass, ray.ends_at_obstacle ? 2 : 0);
  }
  for (const Ray& ray : rays) {
    if (!ray.ends_at_obstacle) continue;
    const Cell hit = frame_.cell_of(ray.segment.b);
    for_each_cell({{hit.x - 1, hit.y - 1}, {hit.x + 2, hit.y + 2}}, [&](const Cell& cell) {
      add(cell, cell == hit ? kHitHalfSteps : kNeighborHalfSteps);
    });
  }
}

void HimmGrid::mark_robot(const Pose2& grid_from_robot, const RobotFootprint& footprint) {
  const PointTransform robot_from_grid(inverse(grid_from_robot));
  const double reach_m = std::hypot(footprint.length_m, footprint.width_m) / 2.0;
  const Point2 reach = Point2::Constant(reach_m);
  const Cell low = frame_.cell_of(grid_from_robot.position() - reach);
  const Cell high = frame_.cell_of(grid_from_robot.position() + reach);
  cover(low);
  cover(high);
  for_each_cell({low, {high.x + 1, high.y + 1}}, [&](const Cell& cell) {
    const Point2 at = robot_from_grid * frame_.center_of(cell);
    const bool under =
        std::abs(at.x()) <= footprint.length_m / 2.0 && std::abs(at.y()) <= footprint.width_m / 2.0;
    if (under) cells_[box_.index_of(cell)] = kRobotPath;
  });
}

std::vector<Ray> rays_of(const RangeReading& reading, const Pose2& grid_from_robot,
                         const RayOptions& options, std::int64_t& ignored) {
  const RangeSensor& sensor = *reading.sensor;
  std::vector<Ray> rays;
  rays.reserve(reading.ranges_m.size());
  const PointTransform place(grid_from_robot);
  for (std::size_t i = 0; i < reading.ranges_m.size(); ++i) {
    const double range_m = reading.ranges_m[i];
    if (!std::isfinite(range_m) || range_m <= 0.0) {
      ++ignored;
      continue;
    }
    const bool is_obstacle = range_m < sensor.max_range_m && range_m <= options.max_mapped_range_m;
    const double free_m =
        sensor.kind == SensorKind::laser ? options.laser_no_echo_m : options.sonar_no_echo_m;
    const double seen_m =
        is_obstacle ? range_m : std::min({range_m, free_m, options.max_mapped_range_m});
    const Pose2& beam = sensor.robot_from_beam[i];
    const Point2 origin = place * beam.position();
    const Pose2 grid_from_beam{origin.x(), origin.y(),
                               wrap_angle(grid_from_robot.theta_rad + beam.theta_rad)};
    rays.push_back({{origin, grid_from_beam * Point2(seen_m, 0.0)}, is_obstacle});
  }
  return rays;
}

}  // namespace roomatlas
