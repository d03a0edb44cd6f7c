// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cell_grid.hpp"

#include "roomatlas/plan/floor_plan.hpp"

#include <cstdint>
#include <functional>

namespace roomatlas::io {

/// Where the cells of a plan lie.
struct RasterFrame {
  Point2 origin_m = Point2::Zero();  ///< lower left corner, building metres
  double cell_m = 0.05;              ///< side of a cell
  int width = 1;
  int height = 1;
};

/// A plan, or some rows of it, as cells; (0, 0) is the lower left one.
struct PlanRaster {
  /// The greys of nav2's maps.
  static constexpr std::uint8_t kOccupied = 0;
  static constexpr std::uint8_t kUnknown = 205;  ///< between its thresholds
  static constexpr std::uint8_t kFree = 254;     ///< nearly white

  Point2 origin_m = Point2::Zero();  ///< lower left corner of the frame, building metres
  double cell_m = 0.05;              ///< side of a cell
  int first_row = 0;                 ///< of the frame that is here
  CellGrid<std::uint8_t> cells;
};

/// All cells of the raster whose centres lie in the polygon, by the even-odd rule.
void for_each_cell_in(const Polygon& polygon, const PlanRaster& raster,
                      const std::function<void(int x, int y)>& visit);

/// True where `frame_of` would throw.
[[nodiscard]] bool is_too_large(const FloorPlan& plan, double cell_m, double margin_m);

/// Of a plan with so much unknown space around; the origin lies on a whole number of cells. One
/// cell for an empty plan. Throws InputError for more than 2^28 cells.
[[nodiscard]] RasterFrame frame_of(const FloorPlan& plan, double cell_m, double margin_m);

/// Some rows of a plan.
[[nodiscard]] PlanRaster rows_of(const FloorPlan& plan, const RasterFrame& frame, int first_row,
                                 int rows);

/// All rows, in `frame_of`'s frame.
[[nodiscard]] PlanRaster raster_of(const FloorPlan& plan, double cell_m, double margin_m);

}  // namespace roomatlas::io
