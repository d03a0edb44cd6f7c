// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/occupancy.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr double kStrongFace_m = 0.6;  // shorter faces stop no beams: they may be one bad echo's
constexpr int kOftenSeen = 20;         // a cell that so many beams reached ...
constexpr double kSeldomHit = 0.04;  // ... and so few of them hit is no wall, whatever stands there
constexpr int kBorderCells = 4;      // around everything, so that walls at the rim are closed

/// Visits the cells of a stretch of a face, moved along its normal.
template <typename Visit>
void for_each_cell_of(const WallFace& face, const Interval& stretch, double moved_m,
                      const CellFrame& frame, Visit visit) {
  const Point2 off = moved_m * face.normal();
  for_each_cell_on_line(frame.cell_of(face.at(stretch.low_m) + off),
                        frame.cell_of(face.at(stretch.high_m) + off), [&](const Cell& cell) {
                          visit(cell);
                          return true;
                        });
}

/// Where sonars' beams end at the latest: just behind the faces of walls, but for where beams went
/// on all the same, and the robot itself.
CellMask stops_of(const BuildingEvidence& evidence, const std::vector<WallFace>& faces,
                  const OccupancyOptions& options) {
  const CellFrame& frame = evidence.counts.frame();
  CellMask stops(evidence.counts.domain(0));
  for (const WallFace& face : faces) {
    if (face.support_m() < kStrongFace_m) continue;
    for (const Interval& stretch : face.seen) {
      for_each_cell_of(face, stretch, -options.stop_behind_m, frame,
                       [&](const Cell& cell) { stops.set(cell, true); });
    }
  }
  for_each_cell(stops.domain, [&](const Cell& cell) {
    if (!stops.at(cell)) return;
    const CellCounts counts = evidence.counts.at(cell);
    if (counts.hits + counts.passes <= kOftenSeen) return;
    double most = 0.0;
    for_each_cell({{cell.x - 1, cell.y - 1}, {cell.x + 2, cell.y + 2}}, [&](const Cell& near) {
      most = std::max(most, evidence.counts.at(near).reflected_share());
    });
    if (most < kSeldomHit) stops.set(cell, false);
  });
  return stops;
}

/// The echoes' rays, each ended at the first stop.
ReflectionMap counted_again(const BuildingEvidence& evidence, const CellMask& stops) {
  const CellFrame& frame = evidence.counts.frame();
  ReflectionMap counts(frame.cell_m);
  for (const Echo& echo : evidence.echoes) {
    const bool ends_at_echo = echo.is_hit && echo.free_m >= echo.range_m;
    Ray ray{
        {echo.building_from_beam.position(), echo.building_from_beam * Point2(echo.free_m, 0.0)},
        ends_at_echo};
    Cell last = frame.cell_of(ray.segment.a);
    for_each_cell_on_line(last, frame.cell_of(ray.segment.b), [&](const Cell& cell) {
      if (!stops.at(cell)) return true;
      ray = {{ray.segment.a, frame.center_of(cell)}, false};
      return false;
    });
    counts.add_sweep({ray});
  }
  return counts;
}

void clear_path(const std::vector<Pose2>& path, double reach_m, Occupancy& occupancy) {
  const int reach = static_cast<int>(std::lround(reach_m / occupancy.frame.cell_m));
  for (const Pose2& pose : path) {
    const Cell at = occupancy.frame.cell_of(pose.position());
    for_each_cell({{at.x - reach, at.y - reach}, {at.x + reach + 1, at.y + reach + 1}},
                  [&](const Cell& cell) {
                    occupancy.seen.set(cell, true);
                    occupancy.free.set(cell, true);
                    occupancy.obstacle.set(cell, false);
                  });
  }
}

}  // namespace

Occupancy occupancy_of(const BuildingEvidence& evidence, const std::vector<WallFace>& faces,
                       const OccupancyOptions& options) {
  const bool is_sonar = evidence.kind == SensorKind::sonar;
  const ReflectionMap counts =
      is_sonar ? counted_again(evidence, stops_of(evidence, faces, options)) : evidence.counts;
  const CellDomain domain = evidence.counts.domain(kBorderCells);
  Occupancy occupancy{counts.frame(), CellMask(domain), CellMask(domain), CellMask(domain)};
  for_each_cell(domain, [&](const Cell& cell) {
    const CellCounts seen = counts.at(cell);
    const bool is_obstacle =
        seen.hits >= options.min_hits && seen.reflected_share() >= options.occupied_share;
    occupancy.seen.set(cell, seen.is_seen());
    occupancy.obstacle.set(cell, is_obstacle && !is_sonar);
    occupancy.free.set(cell, !is_obstacle && seen.hits + seen.passes >= options.min_seen);
  });
  clear_path(evidence.building_from_robot, options.path_clear_m, occupancy);
  if (!is_sonar) return occupancy;
  for (const WallFace& face : faces) {
    for (const Interval& stretch : face.seen) {
      for_each_cell_of(face, stretch, 0.0, occupancy.frame, [&](const Cell& cell) {
        occupancy.obstacle.set(cell, true);
        occupancy.free.set(cell, false);
        occupancy.seen.set(cell, true);
      });
    }
  }
  return occupancy;
}

}  // namespace roomatlas
