// SPDX-License-Identifier: GPL-3.0-or-later
#include "open_floor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "roomatlas/polyline/distance_field.hpp"
#include "roomatlas/polyline/small_part.hpp"

namespace roomatlas {
namespace {

constexpr double kNearObstacleM = 0.15;  // what was cleaned away in front of a wall, and noise
constexpr double kWallNoiseM = 0.08;     // of walls that a moving robot saw
constexpr int kTurns = 9;                // in which an island is measured, 10 degrees apart

/// Visits each 8-connected component of at most `most` cells that are not in the mask.
template <typename Visit>
void for_each_gap(const CellMask& mask, std::size_t most, Visit visit) {
  CellMask seen = mask;
  for_each_cell(mask.domain, [&](const Cell& start) {
    if (seen.at(start)) return;
    const std::vector<Cell> gap = small_part(
        start, most, [](const Cell&) { return true; }, seen);
    if (!gap.empty()) visit(gap);
  });
}

/// The side of the smallest square around some cells, over a few turns.
double square_side_cells(const std::vector<Cell>& cells) {
  double smallest = std::numeric_limits<double>::infinity();
  for (int turn = 0; turn < kTurns; ++turn) {
    const Point2 along = direction(kPi / 2.0 * turn / kTurns);
    Box2 box;
    for (const Cell& cell : cells) {
      const Point2 at(cell.x, cell.y);
      box.extend({along.dot(at), cross(along, at)});
    }
    smallest = std::min(smallest, box.size().maxCoeff() + 1.0);
  }
  return smallest;
}

std::size_t cells_up_to(double count) { return static_cast<std::size_t>(std::max(0.0, count)); }

CellMask cropped(const CellMask& mask) {
  const CellBox& all = mask.domain.bounds();
  CellBox box{all.max, all.min};
  for_each_cell(mask.domain, [&](const Cell& cell) {
    if (!mask.at(cell)) return;
    box.min = {std::min(box.min.x, cell.x), std::min(box.min.y, cell.y)};
    box.max = {std::max(box.max.x, cell.x + 1), std::max(box.max.y, cell.y + 1)};
  });
  if (box.min.x >= box.max.x) return CellMask(CellBox{});
  box.min = {box.min.x - 1, box.min.y - 1};
  box.max = {box.max.x + 1, box.max.y + 1};
  CellMask result(mask.domain.within(box));
  for_each_cell(result.domain, [&](const Cell& cell) { result.set(cell, mask.at(cell)); });
  return result;
}

/// Cells that a disc of `radius_m` covers which fits into the mask (a morphological opening).
CellMask opened_by_disc(const CellMask& mask, const CellFrame& frame, double radius_m) {
  const auto reach_cells = static_cast<float>(radius_m / frame.cell_m);
  const auto away_from_centres = [&] {
    CellMask away(mask.domain);
    const Raster<float> inside = distance_inside(mask);
    for (std::size_t i = 0; i < inside.values.size(); ++i) {
      away.bits[i] = inside.values[i] > reach_cells ? 0 : 1;
    }
    return away;
  };
  const Raster<float> off = distance_inside(away_from_centres());
  CellMask result(mask.domain);
  for (std::size_t i = 0; i < off.values.size(); ++i) {
    result.bits[i] = off.values[i] <= reach_cells && mask.bits[i] != 0 ? 1 : 0;
  }
  return result;
}

}  // namespace

Raster<float> clearance_m(const CellMask& mask, const CellFrame& frame) {
  Raster<float> clearance = distance_inside(mask);
  const auto cell_m = static_cast<float>(frame.cell_m);
  for (float& value : clearance.values) value = std::max(0.0F, value - 0.5F) * cell_m;
  return clearance;
}

CellMask without_beam_traces(const PartitionEvidence& evidence, const PartitionOptions& options) {
  const CellFrame& frame = evidence.frame;
  CellMask filled = evidence.free;
  const double speck_cells = options.speck_m2 / (frame.cell_m * frame.cell_m);
  for_each_gap(evidence.free, cells_up_to(speck_cells), [&](const std::vector<Cell>& gap) {
    if (static_cast<double>(gap.size()) >= speck_cells) return;
    for (const Cell& cell : gap) filled.set(cell, true);
  });
  std::vector<Cell> on_path;
  for (const Pose2& pose : evidence.building_from_robot) {
    on_path.push_back(frame.cell_of(pose.position()));
    filled.set(on_path.back(), true);
  }
  CellMask wide = opened_by_disc(filled, frame, options.ray_width_m / 2.0);
  for (const Cell& cell : on_path) wide.set(cell, true);
  return connected_to(wide, on_path);
}

CellMask islands_filled(const CellMask& mask, const CellFrame& frame, double side_m) {
  CellMask result = mask;
  const double most_cells = side_m / frame.cell_m;
  for_each_gap(mask, cells_up_to(2.0 * most_cells * most_cells), [&](const std::vector<Cell>& gap) {
    const bool stands_free = std::none_of(
        gap.begin(), gap.end(), [&](const Cell& cell) { return mask.domain.is_at_rim(cell); });
    if (!stands_free || square_side_cells(gap) >= most_cells) return;
    for (const Cell& cell : gap) result.set(cell, true);
  });
  return result;
}

OpenFloor open_floor(const PartitionEvidence& evidence, const PartitionOptions& options) {
  const bool is_mission = !evidence.building_from_robot.empty();
  OpenFloor floor;
  floor.frame = evidence.frame;
  floor.open =
      islands_filled(cropped(is_mission ? without_beam_traces(evidence, options) : evidence.free),
                     floor.frame, options.island_m);
  floor.wall_noise_m = is_mission ? kWallNoiseM : 0.0;
  floor.solid = CellMask(floor.open.domain);
  const int near_cells =
      std::max(1, static_cast<int>(std::lround(kNearObstacleM / floor.frame.cell_m)));
  const CellMask near = is_mission ? dilated(evidence.obstacle, near_cells) : CellMask(CellBox{});
  for_each_cell(floor.open.domain,
                [&](const Cell& cell) { floor.solid.set(cell, !is_mission || near.at(cell)); });
  floor.clearance_m = clearance_m(floor.open, floor.frame);
  return floor;
}

}  // namespace roomatlas
