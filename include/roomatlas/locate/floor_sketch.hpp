// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "roomatlas/asr/store.hpp"
#include "roomatlas/grid/cells.hpp"
#include "roomatlas/loops/closures.hpp"

namespace roomatlas {

/// Where walls and floor are, as far as finding one map in another needs it. In a frame of its own.
struct FloorSketch {
  std::vector<ScanPoint> walls;  ///< one in each 0.1 m x 0.1 m and eighth of a turn of its normal
  std::vector<Point2> floor;     ///< centres of the cells of `kFloorCellM` that were seen free
  std::vector<Point2> path;      ///< of the robot, thinned
};

constexpr double kFloorCellM = 0.2;  ///< finer costs time; coarser closes doors
[[nodiscard]] inline CellFrame floor_cells() { return CellFrame{kFloorCellM}; }

/// The sketch of some visits.
/// @param shapes of these visits, from a laser or from sonars
/// @param placement of each of them in the sketch's frame
[[nodiscard]] FloorSketch sketch_of(std::span<const AsrShape* const> shapes,
                                    const Placement& placement);

/// The same sketch in another frame.
[[nodiscard]] FloorSketch moved(FloorSketch sketch, const Pose2& to_from_sketch);

}  // namespace roomatlas
