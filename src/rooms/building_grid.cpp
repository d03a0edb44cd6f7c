// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/rooms/building_grid.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr int kBorderCells = 2;       // so that nothing that is grown touches the rim
constexpr double kInnerShare = 0.35;  // of the footprint's shorter side, each way; 0.5 is its rim,
                                      // and would free jambs that a pose is a little off

/// The cells under the inner part of the footprint: the rim may touch a door's jamb.
std::vector<Cell> cells_under(const Pose2& building_from_robot, const RobotFootprint& footprint,
                              const CellFrame& frame) {
  const double half_m = kInnerShare * std::min(footprint.length_m, footprint.width_m);
  const double step_m = frame.cell_m / 2.0;
  std::vector<Cell> cells;
  for (double x = -half_m; x <= half_m; x += step_m) {
    for (double y = -half_m; y <= half_m; y += step_m) {
      const Cell cell = frame.cell_of(building_from_robot * Point2(x, y));
      if (cells.empty() || !(cells.back() == cell)) cells.push_back(cell);
    }
  }
  return cells;
}

/// Groups (connected by edges and corners) of fewer cells become free.
void remove_specks(BuildingGrid& grid, int min_cells) {
  CellMask done(grid.obstacle.domain);
  for_each_cell(grid.obstacle.domain, [&](const Cell& start) {
    if (!grid.obstacle.at(start) || done.at(start)) return;
    std::vector<Cell> group = {start};
    done.set(start, true);
    for (std::size_t i = 0; i < group.size(); ++i) {
      const Cell at = group[i];
      for_each_cell({{at.x - 1, at.y - 1}, {at.x + 2, at.y + 2}}, [&](const Cell& near) {
        if (!grid.obstacle.at(near) || done.at(near)) return;
        done.set(near, true);
        group.push_back(near);
      });
    }
    if (group.size() >= static_cast<std::size_t>(min_cells)) return;
    for (const Cell& cell : group) {
      grid.obstacle.set(cell, false);
      grid.free.set(cell, true);
    }
  });
}

}  // namespace

BuildingGrid building_grid(const ReflectionMap& map, SensorKind kind,
                           const std::vector<Pose2>& building_from_robot,
                           const RobotFootprint& footprint, const BuildingGridOptions& options) {
  const double occupied_share =
      kind == SensorKind::sonar ? options.sonar_occupied_share : options.occupied_share;
  const CellDomain domain = map.domain(kBorderCells);
  BuildingGrid grid{map.frame(), CellMask(domain), CellMask(domain), CellMask(domain)};
  for_each_cell(domain, [&](const Cell& cell) {
    const CellCounts counts = map.at(cell);
    const bool is_obstacle =
        counts.hits >= options.min_hits && counts.reflected_share() >= occupied_share;
    grid.obstacle.set(cell, is_obstacle);
    grid.free.set(cell, !is_obstacle && counts.passes >= options.min_passes);
  });
  remove_specks(grid, options.min_obstacle_cells);
  std::vector<Cell> path;
  for (const Pose2& pose : building_from_robot) {
    const Cell at = grid.frame.cell_of(pose.position());
    if (!path.empty() && path.back() == at) continue;
    path.push_back(at);
    for (const Cell& cell : cells_under(pose, footprint, grid.frame)) {
      grid.free.set(cell, true);
      grid.obstacle.set(cell, false);
    }
  }
  const int margin = static_cast<int>(std::lround(options.margin_m / options.cell_m));
  grid.passable = eroded(grid.free, margin);
  for (const Cell& cell : path) grid.passable.set(cell, true);
  grid.passable = connected_to(grid.passable, path);
  return grid;
}

}  // namespace roomatlas
