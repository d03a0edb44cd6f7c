// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/asr/asr.hpp"
#include "roomatlas/grid/himm_grid.hpp"
#include "roomatlas/polyline/clean_map.hpp"
#include "roomatlas/polyline/fit.hpp"

namespace roomatlas {

/// How readings become walls and an outline. Lengths of the paper in cells are of `cell_m`.
struct RoomMapOptions {
  double cell_m = 0.1;              ///< paper IV: 10 cm. Smaller needs more readings a cell
  double max_mapped_range_m = 8.0;  ///< readings beyond it map free space alone; larger smears
                                    ///< walls by the heading drift inside a room
  double sonar_no_echo_m = 1.0;     ///< a sonar without echo frees this much alone: a wall hit at a
                                    ///< flat angle gives none, so larger tears walls open
  double laser_no_echo_m = 5.0;     ///< the same for a laser without echo in the mapped range;
                                    ///< larger maps what glass lets through as room
  double epsilon = 7.0;             ///< paper IV: C above it is occupied
  double gamma_cells = 4.0;         ///< paper IV: largest gap inside a polyline
  double tau_cells = 2.0;           ///< paper IV: points closer than this are dropped
  double simplify_tolerance_m = 0.12;  ///< Douglas-Peucker; the paper gives none. Over one cell,
                                       ///< so that steps of the raster do not become corners
  double sonar_simplify_tolerance_m = 0.12;  ///< the same for walls seen by sonars. An echo lies
                                             ///< anywhere across its cone; 0.25 keeps fewer of the
                                             ///< cone's arcs as corners
  bool refine_points = true;      ///< centre the walls in their raised band; false: cell centres
  double insert_every_m = 0.05;   ///< a sweep is mapped after this much motion ...
  double insert_every_deg = 2.0;  ///< ... or turn; standing still would count one view as many
  double min_hole_m2 = 3.0;       ///< smaller holes in the outline (furniture) are filled
  FitOptions fit;
};

/// What a room's readings make of it, in the ASR's frame.
struct RoomMap {
  HimmGrid grid{0.1};  ///< `map_room` makes it, in cells of `RoomMapOptions::cell_m`
  CellMap cleaned;
  std::vector<Polyline> points;      ///< extracted, in order (paper Fig. 2c); one list a wall
  std::vector<Polyline> simplified;  ///< kept by Douglas and Peucker, before the fit (Fig. 7)
  std::vector<WallPolyline> walls;   ///< fitted (Fig. 2d)
  Polygon outline;
  Point2 reference_point = Point2::Zero();
  AsrCounters counters;
};

/// Maps a room from its readings, their poses and its exits (paper III.A to III.E): HIMM,
/// CleanMap, ExtractPoints, Douglas-Peucker, line fit; and the outline of the free space around
/// the path, cut at the door lines. Readings that pass through a doorway end at the door line.
/// A pure function: mapping again from corrected poses is calling it again.
/// @param path and `readings` are parallel
[[nodiscard]] RoomMap map_room(const std::vector<PathSample>& path,
                               const std::vector<RangeReading>& readings,
                               const std::vector<Exit>& exits, const RobotFootprint& footprint,
                               const RoomMapOptions& options);

/// The grid of a room alone: the first step of `map_room`.
[[nodiscard]] HimmGrid himm_of_room(const std::vector<PathSample>& path,
                                    const std::vector<RangeReading>& readings,
                                    const std::vector<Exit>& exits, const RobotFootprint& footprint,
                                    const RoomMapOptions& options, std::int64_t& ignored_ranges);

/// True when a sweep at `to` is worth mapping after one at `from`.
[[nodiscard]] bool moved_enough(const Pose2& from, const Pose2& to, const RoomMapOptions& options);

[[nodiscard]] RayOptions ray_options(const RoomMapOptions& options);

/// Cuts a ray at a doorway: what lies beyond belongs to another room. Nothing when the whole ray
/// lies beyond it.
[[nodiscard]] std::optional<Ray> clipped_at_doorway(const Ray& ray, const Exit& exit);

}  // namespace roomatlas
