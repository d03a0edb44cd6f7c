// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/asr/map_room.hpp"

#include <algorithm>
#include <cmath>

#include "outline.hpp"
#include "roomatlas/polyline/extract_points.hpp"
#include "roomatlas/polyline/simplify.hpp"

namespace roomatlas {
namespace {

/// Points of a wall that stand at a jamb: simplification must not remove them.
std::vector<std::size_t> points_at_jambs(const Polyline& points, const std::vector<Point2>& jambs,
                                         double reach_m) {
  std::vector<std::size_t> pinned;
  for (const Point2& jamb : jambs) {
    const auto nearest =
        std::min_element(points.begin(), points.end(), [&](const auto& a, const auto& b) {
          return (a - jamb).squaredNorm() < (b - jamb).squaredNorm();
        });
    if (nearest != points.end() && (*nearest - jamb).norm() <= reach_m) {
      pinned.push_back(static_cast<std::size_t>(nearest - points.begin()));
    }
  }
  std::sort(pinned.begin(), pinned.end());
  pinned.erase(std::unique(pinned.begin(), pinned.end()), pinned.end());
  return pinned;
}

/// Of Douglas-Peucker: the sonars' where any reading is one of theirs.
double tolerance_m(const std::vector<RangeReading>& readings, const RoomMapOptions& options) {
  const bool has_sonars = std::any_of(
      readings.begin(), readings.end(),
      [](const RangeReading& reading) { return reading.sensor->kind == SensorKind::sonar; });
  return has_sonars ? options.sonar_simplify_tolerance_m : options.simplify_tolerance_m;
}

/// One chain of points becomes a fitted polyline (paper III.D, III.E).
void add_wall(const Polyline& points, const std::vector<Point2>& jambs, double simplify_tolerance_m,
              const RoomMapOptions& options, RoomMap& map) {
  const double jamb_reach_m = 2.0 * options.cell_m;
  const auto pinned = points_at_jambs(points, jambs, jamb_reach_m);
  const auto sparse = decimate(points, options.tau_cells * options.cell_m, pinned);
  Polyline thinned;
  for (const std::size_t index : sparse) thinned.push_back(points[index]);
  const auto pinned_thinned = points_at_jambs(thinned, jambs, jamb_reach_m);
  const auto kept = douglas_peucker(thinned, simplify_tolerance_m, pinned_thinned);
  FittedPolyline fitted = fit_lines(thinned, kept, options.fit, pinned_thinned);
  map.points.push_back(points);
  map.simplified.emplace_back();
  for (const std::size_t index : kept) map.simplified.back().push_back(thinned[index]);
  map.walls.push_back({std::move(fitted.vertices), std::move(fitted.edge_is_fitted)});
}

/// Cells of the smallest box that holds every cell that is not unknown.
std::int64_t cells_in_use(const HimmGrid& grid) {
  CellBox used{grid.box().max, grid.box().min};
  for_each_cell(grid.box(), [&](const Cell& cell) {
    if (grid.raw(cell) == 0) return;
    used.min = {std::min(used.min.x, cell.x), std::min(used.min.y, cell.y)};
    used.max = {std::max(used.max.x, cell.x + 1), std::max(used.max.y, cell.y + 1)};
  });
  return used.width() > 0 && used.height() > 0 ? static_cast<std::int64_t>(used.count()) : 0;
}

std::int64_t count_occupied(const HimmGrid& grid, double epsilon) {
  std::int64_t count = 0;
  for_each_cell(grid.box(), [&](const Cell& cell) {
    if (grid.value(cell) > epsilon) ++count;
  });
  return count;
}

}  // namespace

RoomMap map_room(const std::vector<PathSample>& path, const std::vector<RangeReading>& readings,
                 const std::vector<Exit>& exits, const RobotFootprint& footprint,
                 const RoomMapOptions& options) {
  RoomMap map;
  map.grid = himm_of_room(path, readings, exits, footprint, options, map.counters.ignored_ranges);
  map.cleaned =
      clean_map(map.grid, {.epsilon = options.epsilon, .max_range_m = options.max_mapped_range_m});
  const std::vector<CellChain> chains = extract_points(map.cleaned, options.gamma_cells);
  const std::vector<Point2> jambs = jambs_of(exits);
  const double simplify_tolerance_m = tolerance_m(readings, options);
  for (const Polyline& points :
       chain_points(chains, map.grid, options.epsilon, options.refine_points)) {
    if (points.size() < 2) continue;  // a lone cell is no wall; cleaned_cells still counts it
    add_wall(points, jambs, simplify_tolerance_m, options, map);
    map.counters.extracted_points += static_cast<std::int64_t>(points.size());
    map.counters.vertices += static_cast<std::int64_t>(map.walls.back().vertices_asr.size());
  }
  map.outline = outline_of(map.grid, map.cleaned, path, exits, options);
  map.reference_point = interior_point(map.outline);

  map.counters.grid_cells = cells_in_use(map.grid);
  map.counters.grid_bytes = map.counters.grid_cells;
  map.counters.occupied_cells = count_occupied(map.grid, options.epsilon);
  map.counters.cleaned_cells = map.cleaned.count(CellState::occupied);
  map.counters.geometry_bytes = map.counters.vertices * 2 * 4;
  return map;
}

}  // namespace roomatlas
